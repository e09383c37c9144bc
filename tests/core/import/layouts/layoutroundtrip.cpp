// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "import/importmeasurement.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <charconv>
#include <random>

using namespace palmer;

namespace {

std::mt19937 randomNumbers(11);

PositioningMeasurement randomMeasurement() {
    PositioningMeasurement m;
    const auto targets = 3 + randomNumbers() % 12;
    const auto pairs = 1 + randomNumbers() % 5;
    for (unsigned i = 0; i < targets; ++i)
        m.targets.push_back(static_cast<double>(i * 15000 + randomNumbers() % 9000) / 100);
    for (unsigned j = 0; j < 2 * pairs; ++j) {
        Run run{j % 2 == 0 ? Direction::positive : Direction::negative, {}};
        for (unsigned i = 0; i < targets; ++i) {
            const double tenths =
                static_cast<double>(randomNumbers() % 201) - 100 + (j % 2 == 0 ? 300 : -300);
            run.deviations.emplace_back(tenths / 10'000); // tenths of a micrometre
        }
        m.runs.push_back(std::move(run));
    }
    return m;
}

std::string number(double value, int decimals, bool comma) {
    std::array<char, 64> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals)
            .ptr;
    if (comma)
        std::replace(digits.data(), end, '.', ',');
    return {digits.data(), end};
}

struct Form {
    std::string delimiter;
    bool comma;
};

std::string deviation(const PositioningMeasurement &m, std::size_t j, std::size_t i, const Form &form) {
    return number(*m.runs[j].deviations[i] * 1000, 1, form.comma);
}

std::string target(const PositioningMeasurement &m, std::size_t i, const Form &form) {
    return number(m.targets[i], 2, form.comma);
}

std::string targetsDown(const PositioningMeasurement &m, const Form &form,
                        const std::vector<std::size_t> &order, bool headings) {
    std::string text;
    if (headings) {
        text = "P (mm)";
        for (const std::size_t j : order)
            text += form.delimiter + "dev" + std::to_string(j / 2 + 1) +
                    (m.runs[j].approach == Direction::positive ? "↑(µm)" : "↓(µm)");
        text += '\n';
    }
    for (std::size_t i = 0; i < m.targets.size(); ++i) {
        text += target(m, i, form);
        for (const std::size_t j : order)
            text += form.delimiter + deviation(m, j, i, form);
        text += '\n';
    }
    return text;
}

std::vector<std::size_t> inTurn(const PositioningMeasurement &m) {
    std::vector<std::size_t> order(m.runs.size());
    for (std::size_t j = 0; j < order.size(); ++j)
        order[j] = j;
    return order;
}

std::vector<std::size_t> sideBySide(const PositioningMeasurement &m) {
    std::vector<std::size_t> order;
    for (const std::size_t first : {0U, 1U}) {
        for (std::size_t j = first; j < m.runs.size(); j += 2)
            order.push_back(j);
    }
    return order;
}

std::string written(const PositioningMeasurement &m, const QString &layout, const Form &form) {
    const std::string &d = form.delimiter;
    if (layout == "alternating columns with headings")
        return targetsDown(m, form, inTurn(m), true);
    if (layout == "columns side by side with headings")
        return targetsDown(m, form, sideBySide(m), true);
    if (layout == "alternating columns, bare")
        return targetsDown(m, form, inTurn(m), false);
    if (layout == "columns side by side, bare")
        return targetsDown(m, form, sideBySide(m), false);
    if (layout == "two blocks") {
        std::string text;
        for (const std::size_t first : {0U, 1U}) {
            text += first == 0 ? "Forward\n" : "\nReverse\n";
            for (std::size_t k = 0; k < m.targets.size(); ++k) {
                const std::size_t i = first == 0 ? k : m.targets.size() - 1 - k;
                text += target(m, i, form);
                for (std::size_t j = first; j < m.runs.size(); j += 2)
                    text += d + deviation(m, j, i, form);
                text += '\n';
            }
        }
        return text;
    }
    if (layout == "one column that goes up and down") {
        std::string text = "P (mm)" + d + "dev (µm)\n";
        for (std::size_t j = 0; j < m.runs.size(); ++j) {
            for (std::size_t k = 0; k < m.targets.size(); ++k) {
                const std::size_t i = j % 2 == 0 ? k : m.targets.size() - 1 - k;
                text += target(m, i, form) + d + deviation(m, j, i, form) + '\n';
            }
        }
        return text;
    }
    if (layout == "runs down") {
        std::string text = "run" + d + "dir";
        for (std::size_t i = 0; i < m.targets.size(); ++i)
            text += d + target(m, i, form);
        for (std::size_t j = 0; j < m.runs.size(); ++j) {
            text += '\n' + std::to_string(j / 2 + 1) + d + (j % 2 == 0 ? "fwd" : "bwd");
            for (std::size_t i = 0; i < m.targets.size(); ++i)
                text += d + deviation(m, j, i, form);
        }
        return text + '\n';
    }
    // A list, its lines in any order.
    std::vector<std::string> lines;
    for (std::size_t j = 0; j < m.runs.size(); ++j) {
        for (std::size_t i = 0; i < m.targets.size(); ++i)
            lines.push_back(std::to_string(i + 1) + d + target(m, i, form) + d + (j % 2 == 0 ? "+" : "-") +
                            d + std::to_string(j / 2 + 1) + d + deviation(m, j, i, form) + '\n');
    }
    std::string text = "i" + d + "target" + d + "direction" + d + "run" + d + "deviation\n";
    for (const std::string &line : lines)
        text += line;
    return text;
}

} // namespace

class LayoutRoundTripTest : public QObject {
    Q_OBJECT

private slots:
    void everyLayoutSaysTheSame_data();
    void everyLayoutSaysTheSame();
};

void LayoutRoundTripTest::everyLayoutSaysTheSame_data() {
    QTest::addColumn<QString>("layout");
    for (const char *layout : {"alternating columns with headings", "columns side by side with headings",
                               "alternating columns, bare", "columns side by side, bare", "two blocks",
                               "one column that goes up and down", "runs down", "list"})
        QTest::newRow(layout) << QString(layout);
}

void LayoutRoundTripTest::everyLayoutSaysTheSame() {
    QFETCH(QString, layout);
    const std::array forms{Form{";", true}, Form{";", false}, Form{",", false}, Form{"\t", true},
                           Form{" | ", false}};
    for (int trial = 0; trial < 60; ++trial) {
        const PositioningMeasurement expected = randomMeasurement();
        const Form form = forms[static_cast<std::size_t>(trial) % forms.size()];
        const std::string text = written(expected, layout, form);
        const Imported imported = importMeasurement(QByteArray::fromStdString(text), "x.csv",
                                                    {{"unit", "um"}, {"positionUnit", "mm"}});
        QVERIFY2(imported.test, text.c_str());
        const auto &read = std::get<PositioningMeasurement>(imported.test->measurement);
        QVERIFY2(read.targets == expected.targets, text.c_str());
        QVERIFY2(read.runs == expected.runs, text.c_str());
    }
}

QTEST_GUILESS_MAIN(LayoutRoundTripTest)
#include "layoutroundtrip.moc"
