// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"
#include "language/language.h"

#include <QByteArray>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace palmer {

/// A place where a report does not say what follows from its data.
struct Difference {
    int page = 0; ///< from 1; 0: of no page
    QRectF area;  ///< on the page, points from its top left corner; empty: the whole
    QString printed;
    QString follows;
    QString context;             ///< the words around it as they follow; of results their path
    std::optional<Message> what; ///< null: words differ; else what is wrong, with `context` beside it

    bool operator==(const Difference &) const = default;
};

/// A signature in the PDF.
struct SignatureStatement {
    enum class State {
        valid,
        broken, ///< what it covers was changed after it was made
        unknown ///< it could not be checked
    };
    QString signer;
    QString time; ///< ISO 8601, UTC
    State state = State::unknown;
    bool whole = false;   ///< covers the whole file
    bool trusted = false; ///< its certificate leads to an authority this machine trusts
};

/// The outcome of recomputing a report from the test file inside it.
struct Verification {
    bool identical = false;              ///< the whole PDF, byte for byte
    bool appended = false;               ///< the PDF as it was made stands unchanged before what was appended
    QString madeBy;                      ///< "Palmer 0.1.0"
    QString fingerprint;                 ///< of the attached file
    bool fingerprintPrinted = true;      ///< on every page
    std::vector<Difference> differences; ///< in the order of the pages
    bool otherVersion = false;       ///< made by another version: results and verdicts are compared, no more
    std::vector<Difference> wording; ///< what that version prints otherwise: not compared
    std::vector<SignatureStatement> signatures;

    /// Every printed number follows from the attached data.
    [[nodiscard]] bool follows() const { return differences.empty(); }
};

/// What is said of the outcome: one sentence, then what it does not say.
[[nodiscard]] QString conclusion(const Verification &verification, const Language &language);

/// One line about a difference: page, what is printed, what follows, the words around it.
[[nodiscard]] QString differenceText(const Difference &difference, const Language &language);

/// One line about a signature.
[[nodiscard]] QString signatureText(const SignatureStatement &signature, const Language &language);

/// All of it, for a terminal.
[[nodiscard]] QString verificationText(const Verification &verification, const Language &language);

/// "palmer verification", one object; ends with a line break.
[[nodiscard]] QByteArray verificationJson(const Verification &verification, const QString &fileName,
                                          const Language &language, bool oneLine);

} // namespace palmer
