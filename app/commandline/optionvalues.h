// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "document/document.h"
#include "export/partprogram.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/axis.h"

#include <QByteArray>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

namespace palmer {

/// Throws UsageError: "--OPTION cannot be GIVEN; expected FORM".
[[noreturn]] void refuse(const char *option, const QString &given, const std::string &form);

/// The value of an option with a point or a comma, with or without a power of ten (1e3); null without the
/// option. Throws UsageError if it is no finite number, and for "1,000", which may be one or a thousand.
[[nodiscard]] std::optional<double> numberOf(const Invocation &invocation, const char *option);

/// Throws UsageError for "1,000", which may be one or a thousand.
void requireClearComma(const std::string &option, const QString &given);

/// Parses the number `given` to the option. Throws like numberOf().
[[nodiscard]] double numberGiven(const char *option, const QString &given);

/// The same, from `least` to `most`, or greater than a bound.
[[nodiscard]] double numberBetween(const char *option, const QString &given, double least, double most);
[[nodiscard]] double numberAbove(const char *option, const QString &given, double bound);

/// "FROM:TO", ascending. Throws UsageError.
[[nodiscard]] Interval intervalGiven(const char *option, const QString &given);

/// Parses an integer, also with a power of ten (1e6); null for anything else.
[[nodiscard]] std::optional<long long> wholeGiven(const QString &given);

/// The same, from `least` to `most`; also of an argument, called as in the help (MONTHS). Throws UsageError.
[[nodiscard]] long long wholeBetween(const char *option, const QString &given, long long least,
                                     long long most);

/// How CSV is written: with a point, or after --decimal-mark for spreadsheets, which want a byte-order mark.
struct CsvMarks {
    char decimal = '.';
    QByteArray begin; ///< of the file
};
[[nodiscard]] CsvMarks csvMarks(const Invocation &invocation);

/// Index of the test chosen by --test (from 1) out of `count`; by default the first. Throws UsageError if
/// there is none.
[[nodiscard]] std::size_t testIndex(const Invocation &invocation, std::size_t count);
[[nodiscard]] std::size_t testIndex(const QString &word, std::size_t count);

/// Value of --seed, an integer that a test file can store; null without it. Throws UsageError.
[[nodiscard]] std::optional<std::int64_t> seedOf(const Invocation &invocation);

/// Returns the edition with this designation, like editionAsked(). Throws UsageError.
[[nodiscard]] const Edition *editionCalled(const QString &word, std::optional<Kind> kind = {});

/// The edition of --edition, null without the option: its designation or an unambiguous part of it, in any
/// case, with or without blanks ("2006", "iso230-4:2005", "VDI"). Throws UsageError with the possible
/// editions, of the given kind if any.
[[nodiscard]] const Edition *editionAsked(const Invocation &invocation, std::optional<Kind> kind = {});

/// The dialect of a part program that an option names, or `otherwise` without it.
[[nodiscard]] std::optional<Dialect> dialectOf(const Invocation &invocation, const char *option,
                                               std::optional<Dialect> otherwise = {});

/// Endings of part programs, see requireOutput().
constexpr std::initializer_list<const char *> programEndings{"nc",  "ngc", "mpf", "spf", "h",
                                                             "iso", "cnc", "tap", "txt"};

/// Throws UsageError if no test has the kind of the edition, which would then have no effect.
void requireTestOf(const Edition &edition, const Document &document);

} // namespace palmer
