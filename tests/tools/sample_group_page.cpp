// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// Writes the page of a made-up collection, to look at and for the tests of the page:
// sample_group_page FILE.html [SHAPES [VERTICES]]
#include <exception>
#include <iostream>
#include <string>

#include "isomatch/io/atomic_file.h"
#include "tools/sample_collection.h"

int main(int argc, char** argv) {
  try {
    const int shapes = argc > 2 ? std::stoi(argv[2]) : 40;
    const int vertices = argc > 3 ? std::stoi(argv[3]) : 3000;
    if (argc < 2) throw std::invalid_argument("name the page");
    isomatch::AtomicFile file(argv[1]);
    file.write(
        isomatch::results::group_page(isomatch::results::sample_collection(shapes, vertices)));
    file.commit();
  } catch (const std::exception& error) {
    std::cerr << "sample_group_page: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
