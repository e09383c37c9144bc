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

/// A place where a report differs from what follows from its data.
struct Difference {
    int page = 0; ///< from 1; 0: no page
    QRectF area;  ///< on the page, points from its top left corner; empty: the whole page
    QString printed;
    QString follows;
    QString context;             ///< expected words around it; for results: their path
    std::optional<Message> what; ///< null: words differ; otherwise what is wrong, followed by `context`

    bool operator==(const Difference &) const = default;
};

/// A signature in the PDF.
struct SignatureStatement {
    enum class State {
        valid,
        broken, ///< the signed content was changed afterwards
        unknown ///< it could not be checked
    };
    QString signer;
    QString time; ///< ISO 8601, UTC
    State state = State::unknown;
    bool whole = false;   ///< covers the whole file
    bool trusted = false; ///< its certificate chain ends at an authority this machine trusts
};

/// Outcome of recomputing a report from the test file inside it.
struct Verification {
    bool ofHistory = false;              ///< carries values of tests instead of a test file
    bool identical = false;              ///< the whole PDF, byte for byte
    bool appended = false;               ///< the original PDF is unchanged before the appended part
    QString madeBy;                      ///< "Palmer 0.1.0"
    QString fingerprint;                 ///< of the attached test file
    bool fingerprintPrinted = true;      ///< true if printed on every page
    std::vector<Difference> differences; ///< in page order
    bool otherVersion = false;           ///< made by another version: only results and verdicts are compared
    std::vector<Difference> wording;     ///< other differences of that version; not counted
    std::vector<SignatureStatement> signatures;

    /// True if every printed number follows from the attached data.
    [[nodiscard]] bool follows() const { return differences.empty(); }
};

/// The conclusion: one sentence, then its limits.
[[nodiscard]] QString conclusion(const Verification &verification, const Language &language);

/// One line about a difference: page, printed and expected text, the words around it.
[[nodiscard]] QString differenceText(const Difference &difference, const Language &language);

/// One line about a signature.
[[nodiscard]] QString signatureText(const SignatureStatement &signature, const Language &language);

/// All of the above, for a terminal.
[[nodiscard]] QString verificationText(const Verification &verification, const Language &language);

/// The verification as JSON, "palmer verification", one object; ends with a line break.
[[nodiscard]] QByteArray verificationJson(const Verification &verification, const QString &fileName,
                                          const Language &language, bool oneLine);

} // namespace palmer
