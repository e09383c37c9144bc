// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer::testdata {

/// A test of a program that has many: `core_tests core/document/edits …` runs it with what follows.
struct TestRow {
    /// `file`: the source of the test, whose path names it; `run`: its main function.
    TestRow(const char *file, int (*run)(int, char **));
};

} // namespace palmer::testdata

// NOLINTBEGIN(cppcoreguidelines-macro-usage): Qt's macros are such
/// Stands for "int main(int argc, char *argv[])".
#define PALMER_TEST(name)                                                                                    \
    static int name(int argc, char *argv[]);                                                                 \
    static const palmer::testdata::TestRow name##Row(__FILE__, name);                                        \
    static int name([[maybe_unused]] int argc, [[maybe_unused]] char *argv[])

#undef QTEST_MAIN_WRAPPER
#define QTEST_MAIN_WRAPPER(TestClass, ...)                                                                   \
    PALMER_TEST(run##TestClass) {                                                                            \
        __VA_ARGS__                                                                                          \
        TestClass test;                                                                                      \
        return QTest::qExec(&test, argc, argv);                                                              \
    }
// NOLINTEND(cppcoreguidelines-macro-usage)
