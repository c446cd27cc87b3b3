#!/bin/bash
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
# GNU parallel over the shares of a batch, of which one is killed and done again by --resume-failed,
# leaves what one process leaves: no pair is lost or matched twice.
# Usage: parallel_test.sh PROGRAM
set -euo pipefail
isomatch=$1
# shellcheck source=tests/cluster/pairs.sh
. "$(dirname "$0")/pairs.sh"
parallel --version 2>/dev/null | grep --quiet GNU || skip "cluster.parallel: GNU parallel is not installed"
work=$(mktemp --directory)
running=
finish() {
  [ -z "$running" ] || kill "$running" 2>/dev/null || true
  rm -rf "$work"
}
trap finish EXIT
make_pairs 5 "$work"
cd "$work"

shares() {
  parallel --will-cite --jobs 2 --joblog jobs.log "$@" \
    "$isomatch" batch pairs.csv -o matched --shard '{}/4' --quiet "${quick[@]}" ::: 1 2 3 4
}

shares &
running=$!
for _ in $(seq 300); do
  [ ! -s matched/batch-1-of-4.log ] || break
  sleep .05
done
victim=$(pgrep --full -- "^$isomatch batch pairs.csv .*--shard 1/4") || fail "no program of share 1"
kill -9 "$victim"
if wait "$running"; then fail "parallel does not say that a share failed"; fi
running=
[ "$(awk 'NR > 1 && $8 == 9' jobs.log | wc -l)" = 1 ] || fail "the log of jobs: $(cat jobs.log)"
shares --resume-failed || fail "--resume-failed"
"$isomatch" batch pairs.csv -o matched --merge --quiet "${quick[@]}" || fail "--merge"
compare alone matched
matched_once matched pairs.csv 1
echo "$(wc -l <pairs.csv) pairs in 4 shares, of which one was killed: the same files"

# Several machines, of which each is this one. Their home, from where ssh starts and parallel reckons
# folders, is not the user's, who may have none.
export HOME=$work/home SHELL=/bin/bash
mkdir "$HOME"
cat >ssh <<'EOF'
#!/bin/bash
cd "$HOME" || exit
while [[ $1 = -* ]]; do shift; done
shift
[ "$1" != -- ] || shift
exec bash -c "$*"
EOF
chmod +x ssh
parallel --will-cite --ssh "$PWD/ssh" --sshlogin 1/node1,1/node2 --workdir . --joblog nodes.log \
  "$isomatch" batch pairs.csv -o nodes --threads 1 --shard '{}/4' --quiet "${quick[@]}" ::: 1 2 3 4 ||
  fail "--sshlogin"
[ "$(awk 'NR > 1 { print $2 }' nodes.log | sort --unique | wc -l)" = 2 ] || fail "one machine did all"
"$isomatch" batch pairs.csv -o nodes --merge --quiet "${quick[@]}" || fail "--merge"
compare alone nodes
matched_once nodes pairs.csv 0
