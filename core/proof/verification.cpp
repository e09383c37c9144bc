// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/verification.h"

#include "document/json.h"
#include "document/jsonformats.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace palmer {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t mostLines = 200; ///< differences printed on a terminal

Json differenceJson(const Difference &difference, const Language &language) {
    Json result{{"page", std::max(difference.page, 0)},
                {"printed", difference.printed.toStdString()},
                {"follows", difference.follows.toStdString()},
                {"context", difference.context.toStdString()}};
    if (!difference.area.isEmpty())
        result["area"] = {difference.area.left(), difference.area.top(), difference.area.right(),
                          difference.area.bottom()};
    if (difference.what)
        result["what"] = language.sentence(*difference.what).toStdString();
    return result;
}

Json signatureJson(const SignatureStatement &signature) {
    return {{"signer", signature.signer.toStdString()},
            {"time", signature.time.isEmpty() ? Json(nullptr) : Json(signature.time.toStdString())},
            {"valid", signature.state == SignatureStatement::State::unknown
                          ? Json(nullptr)
                          : Json(signature.state == SignatureStatement::State::valid)},
            {"whole", signature.whole},
            {"trusted", signature.trusted}};
}

Text stateText(SignatureStatement::State state) {
    return inOrder(state, {REPORT_TEXT("report", "valid"),
                           REPORT_TEXT("report", "NOT valid: changed after it was signed"),
                           REPORT_TEXT("report", "could not be checked")});
}

QString withDetail(const QString &what, const QString &detail, const Language &language) {
    return language.sentence(REPORT_TEXT_FOR("report", "%1: %2", "what is said, and of what"),
                             {what.toStdString(), detail.toStdString()});
}

} // namespace

QString conclusion(const Verification &verification, const Language &language) {
    if (verification.follows() && verification.ofHistory)
        return language.text(REPORT_TEXT(
            "report", "The trend follows from the attached values; the tests themselves are not attached."));
    if (verification.follows() && verification.otherVersion)
        return language.sentence(
            REPORT_TEXT("report",
                        "Results and verdicts follow from the attached data; other texts and pictures of "
                        "%1 are not compared. Where the data come from is not verified."),
            {verification.madeBy.toStdString()});
    if (verification.follows())
        return language.text(REPORT_TEXT("report",
                                         "The numbers follow from the attached data. Where the data "
                                         "come from is not verified."));
    return language.sentence(
        {REPORT_TEXT_COUNTED("report",
                             "%n difference(s): the report does not follow from the attached data."),
         {},
         static_cast<int>(verification.differences.size())});
}

QString differenceText(const Difference &difference, const Language &language) {
    QString text;
    if (difference.what) {
        text = language.sentence(*difference.what);
        if (!difference.context.isEmpty())
            text = withDetail(text, difference.context, language);
    } else {
        const std::string dash = "–";
        text = language.sentence(REPORT_TEXT("report", "printed “%1”, follows “%2”"),
                                 {difference.printed.isEmpty() ? dash : difference.printed.toStdString(),
                                  difference.follows.isEmpty() ? dash : difference.follows.toStdString()});
        if (!difference.context.isEmpty())
            text += QStringLiteral(" (") + difference.context + u')';
    }
    if (difference.page == 0)
        return text;
    return language.sentence(REPORT_TEXT("report", "page %1: %2"),
                             {wholeNumber(difference.page), text.toStdString()});
}

QString signatureText(const SignatureStatement &signature, const Language &language) {
    QStringList parts{language.text(stateText(signature.state))};
    parts << language.text(
        signature.whole ? REPORT_TEXT("report", "covers the whole file")
                        : REPORT_TEXT("report", "does not cover the whole file: something was appended "
                                                "after it"));
    parts << language.text(signature.trusted
                               ? REPORT_TEXT("report", "certificate of an authority known here")
                               : REPORT_TEXT("report", "certificate of no authority known here"));
    const QString who =
        language.sentence(REPORT_TEXT("report", "Signature of %1, %2"),
                          {signature.signer.isEmpty() ? std::string("–") : signature.signer.toStdString(),
                           signature.time.isEmpty() ? std::string("–") : signature.time.toStdString()});
    return withDetail(who, parts.join(QStringLiteral("; ")), language);
}

QString verificationText(const Verification &verification, const Language &language) {
    QStringList lines{conclusion(verification, language)};
    const auto add = [&lines](const QString &line) { lines << QStringLiteral("  ") + line; };
    if (!verification.fingerprintPrinted)
        add(language.text(
            REPORT_TEXT("report", "The fingerprint on the pages is not that of the attached file.")));
    for (std::size_t i = 0; i < std::min(verification.differences.size(), mostLines); ++i)
        add(differenceText(verification.differences[i], language));
    if (verification.differences.size() > mostLines)
        add(language.sentence(REPORT_TEXT("report", "… and %1 more; --json has them all"),
                              {wholeNumber(verification.differences.size() - mostLines)}));
    add(language.sentence(REPORT_TEXT("report", "made by %1; fingerprint of the attached file %2"),
                          {verification.madeBy.toStdString(), verification.fingerprint.toStdString()}));
    if (verification.identical)
        add(language.text(REPORT_TEXT("report", "The whole PDF is the same, byte for byte.")));
    else if (verification.appended)
        add(language.text(
            REPORT_TEXT("report", "The PDF as it was made is unchanged; something was appended to it.")));
    else if (verification.follows() && !verification.otherVersion)
        add(language.text(REPORT_TEXT("report",
                                      "The PDF was rewritten: texts, attached files and drawn pages "
                                      "are the same, the bytes are not.")));
    if (!verification.wording.empty())
        add(language.sentence(
            {REPORT_TEXT_COUNTED("report", "%n place(s) that this version prints otherwise: not compared"),
             {},
             static_cast<int>(verification.wording.size())}));
    for (const SignatureStatement &signature : verification.signatures)
        add(signatureText(signature, language));
    return lines.join(u'\n') + u'\n';
}

QByteArray verificationJson(const Verification &verification, const QString &fileName,
                            const Language &language, bool oneLine) {
    const auto list = [&](const std::vector<Difference> &differences) {
        Json result = Json::array();
        for (const Difference &difference : differences)
            result.push_back(differenceJson(difference, language));
        return result;
    };
    Json signatures = Json::array();
    for (const SignatureStatement &signature : verification.signatures)
        signatures.push_back(signatureJson(signature));
    Json file = jsonHead("verification");
    file.update({{"file", fileName.toStdString()},
                 {"ofHistory", verification.ofHistory},
                 {"follows", verification.follows()},
                 {"identical", verification.identical},
                 {"appended", verification.appended},
                 {"madeBy", verification.madeBy.toStdString()},
                 {"otherVersion", verification.otherVersion},
                 {"fingerprint", verification.fingerprint.toStdString()},
                 {"fingerprintPrinted", verification.fingerprintPrinted},
                 {"differences", list(verification.differences)},
                 {"wording", list(verification.wording)},
                 {"signatures", std::move(signatures)}});
    return QByteArray::fromStdString(oneLine ? compactJson(file) + '\n' : printJson(file));
}

} // namespace palmer
