// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/print/pdf/reports.h"

#include <array>
#include <random>

namespace palmer::testdata {

/// Heads, limits, rules and paper as anybody may state them; the same for the same seed.
class Generator {
public:
    explicit Generator(unsigned seed)
        : m_random(seed) {}

    Document document() {
        static const QStringList names{u"limits-2006"_s,
                                       u"budget-2006"_s,
                                       u"one-direction-with-gaps"_s,
                                       u"rotary-axis"_s,
                                       u"iso230-2-1988-example"_s,
                                       u"iso230-4-full-circles-xy"_s,
                                       u"iso230-4-feedback-yz"_s,
                                       u"iso230-4-partial-arc-zx"_s};
        Document document = storedDocument(names[below(static_cast<int>(names.size()))]);
        document.report.paper = below(2) == 0 ? Paper::a4 : Paper::letter;
        fillHead(document.report);
        document.machine.name = words(60);
        document.machine.manufacturer = words(60);
        document.machine.model = words(40);
        Test test = *document.tests.front();
        test.title = words(90);
        addInstruments(document, test);
        addLimits(test);
        document.tests = {std::make_shared<const Test>(std::move(test))};
        if (below(3) == 0) // with a summary and a second test
            document.tests.push_back(storedDocument(u"limits-2006"_s).tests.front());
        return document;
    }

    void addLimits(Test &test) {
        test.limits.clear();
        const bool positioning = std::holds_alternative<PositioningMeasurement>(test.measurement);
        const std::vector<std::string> ids =
            positioning
                ? std::vector<std::string>{"A", "A+", "A-", "E", "E+", "M", "R", "R+", "R-", "B", "Bmean"}
                : std::vector<std::string>{"G(b)", "G", "G(b)f", "Gf", "D", "F", "Fmax"};
        for (const std::string &id : ids) {
            if (below(2) == 0)
                test.limits[id] = {0.0005 * (1 + below(60)), std::nullopt, words(40)};
        }
        test.decisionRule = {std::array{Rule::simpleAcceptance, Rule::iso14253_1, Rule::rejectionProven}.at(
                                 static_cast<std::size_t>(below(3))),
                             below(2) == 0 ? 1.0 : 0.83};
    }

private:
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(m_random); }

    /// Nothing, or words of up to that many letters.
    std::string words(int most) {
        static const char *const known[] = {"Laboratoire", "d’essais", "machine", "centre", "Hall 2", "à",
                                            "vertical",    "GmbH",     "réglage", "of",     "№ 12",   "type"};
        std::string result;
        const int length = below(most);
        while (static_cast<int>(result.size()) < length)
            result += (result.empty() ? "" : " ") + std::string(known[below(12)]);
        return result;
    }
    std::string lines(int most) {
        std::string result = words(40);
        for (int i = below(most); i > 0; --i)
            result += "\n" + words(40);
        return result;
    }

    void fillHead(ReportHead &head) {
        head.title = words(below(4) == 0 ? 160 : 50);
        head.number = "RE-" + std::to_string(below(100000));
        head.revision = words(20);
        head.replaces = words(30);
        head.laboratory.name = words(80);
        head.laboratory.address = lines(4);
        head.laboratory.accreditation = words(60);
        head.place = words(60);
        head.operatorName = words(60);
        head.customer = {words(90), lines(3)};
        head.supplier = {words(90), lines(3)};
    }

    void addInstruments(Document &document, Test &test) {
        test.instruments.clear();
        document.instruments.clear();
        for (int i = below(4); i > 0; --i) {
            Instrument instrument;
            instrument.id = "i" + std::to_string(i);
            instrument.description = words(60);
            instrument.serialNumber = words(20);
            instrument.certificate = words(30);
            instrument.calibrationDate = "2026-03-12";
            document.instruments.push_back(instrument);
            test.instruments.push_back(instrument.id);
        }
    }

    std::mt19937 m_random;
};

/// Places where no line may end, as "last word \nfirst word": within designations of standards, numbers with
/// their units, and references.
inline const QRegularExpression &forbiddenBreaks() {
    static const QRegularExpression forbidden(
        u"(^|[^\\p{L}])(ISO|VDI/DGQ|GB/T|pages?|n°|No\\.|clauses?|articles?|annexe|Annex|[Tt]est|essai) \\n"
        "([0-9]|[A-Z]([^\\p{L}]|$))"
        "| \\n=|= \\n"
        "|[0-9] \\n(mm|µm|m|nm|h|min|s|%|hPa|K|kg|°C|°C/h|mm/min|m/min|µm/\\(m·°C\\))[,.;:)]*( |$)"
        "|[0-9] \\n[0-9]{3}([^0-9\\p{L}-]|$)"_s, // but "Hall 2" and the number "000-004"
        QRegularExpression::UseUnicodePropertiesOption);
    return forbidden;
}

} // namespace palmer::testdata
