// SPDX-License-Identifier: GPL-3.0-or-later
// A test program holds the tests of one folder and runs the one its first argument names:
// "unit_base tst_layering". Each source registers itself under its file's name with one of the
// macros below, in place of Qt's QTEST_MAIN and its kin. With SERVODESK_TEST_PART=2/3 only every
// third row of that test runs, from the second one on.
#pragma once

#include "support/waiting.h"

namespace support {
using TestRun = int (*)(int argc, char** argv);

class RegisteredTest {
public:
    RegisteredTest(const char* file, TestRun run);
};
} // namespace support

/// `run` gets the arguments without the test's name.
#define SERVODESK_TEST_RUN(run)                                                                    \
    static const support::RegisteredTest registered_##run(__FILE__, run);

/// With the application object of a window, where the program links one.
#define SERVODESK_TEST(Class)                                                                      \
    static int run##Class(int argc, char** argv)                                                   \
    {                                                                                              \
        QTEST_MAIN_SETUP()                                                                         \
        Class test;                                                                                \
        return QTest::qExec(&test, argc, argv);                                                    \
    }                                                                                              \
    SERVODESK_TEST_RUN(run##Class)

#define SERVODESK_GUILESS_TEST(Class)                                                              \
    static int run##Class(int argc, char** argv)                                                   \
    {                                                                                              \
        QTEST_QAPP_SETUP(QCoreApplication)                                                         \
        Class test;                                                                                \
        return QTest::qExec(&test, argc, argv);                                                    \
    }                                                                                              \
    SERVODESK_TEST_RUN(run##Class)
