#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""All tables that compare methods, each pair matched once: index, modern, table1, table2, figure8.

What an earlier run of the same program measured is not measured again.
Usage: bench/tables/all.py [--quick] [--out docs/results] [--results build/tables]
"""

import figure8
import index
import modern
import table1
import table2
from rivals import run_table


def make(bench, data, folder, quick, command):
    for page in (modern, table2, table1, figure8, index):
        page.make(bench, data, folder, quick, command)


if __name__ == "__main__":
    run_table(__doc__, make)
