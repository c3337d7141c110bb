// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/test_main.h"

#include <cstdio>
#include <map>
#include <string>

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
    argv[1] = argv[0];
    return found->second(argc - 1, argv + 1);
}
