// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/test_main.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace support {
namespace {
// Made by the first test that registers itself, which may be before anything of this file.
std::map<std::string, TestRun>& tests()
{
    static std::map<std::string, TestRun> all;
    return all;
}
} // namespace

RegisteredTest::RegisteredTest(const char* file, TestRun run)
{
    const std::string path(file);
    const std::size_t begin = path.rfind('/') + 1;
    tests().emplace(path.substr(begin, path.rfind('.') - begin), run);
}

/// Every `count`-th row of a test from row `part` on, counted from 1, as arguments of Qt Test.
std::vector<std::string> rowsOf(const std::string& program, const std::string& test, int part,
                                int count)
{
    std::vector<std::string> rows;
    FILE* const list = popen(("'" + program + "' " + test + " -datatags").c_str(), "r");
    if (list == nullptr)
        return rows;
    std::string line;
    int number = 0;
    for (int c = std::fgetc(list); c != EOF; c = std::fgetc(list)) {
        if (c != '\n') {
            line += char(c);
            continue;
        }
        if (++number % count == part % count) { // "TestClass function row"
            const std::size_t function = line.find(' ') + 1;
            const std::size_t row = line.find(' ', function);
            if (row != std::string::npos)
                line[row] = ':';
            rows.push_back(line.substr(function));
        }
        line.clear();
    }
    if (pclose(list) != 0)
        rows.clear(); // not all of them are known
    return rows;
}
} // namespace support

int main(int argc, char** argv)
{
    const auto found = support::tests().find(argc > 1 ? argv[1] : "");
    if (found == support::tests().end()) {
        std::fprintf(stderr, "Usage: %s TEST [ARGUMENTS OF QTEST]\nTests:\n", argv[0]);
        for (const auto& [name, run] : support::tests())
            std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    std::vector<char*> arguments{argv[0]};
    arguments.insert(arguments.end(), argv + 2, argv + argc);
    std::vector<std::string> rows;
    int part = 0;
    int count = 0;
    const char* const partOption = std::getenv("SERVODESK_TEST_PART");
    if (partOption != nullptr && std::sscanf(partOption, "%d/%d", &part, &count) == 2 &&
        count > 0) {
        unsetenv("SERVODESK_TEST_PART");
        rows = support::rowsOf(argv[0], found->first, part, count);
        if (rows.empty()) {
            std::fprintf(stderr, "%s has no part %d of %d.\n", argv[1], part, count);
            return 2;
        }
    }
    for (std::string& row : rows)
        arguments.push_back(row.data());
    const int size = int(arguments.size());
    arguments.push_back(nullptr);
    return found->second(size, arguments.data());
}
