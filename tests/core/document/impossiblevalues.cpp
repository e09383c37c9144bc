// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/impossiblevalues.h"

#include "core/document/completefile.h"
#include "document/evaluateddocument.h"
#include "document/fields.h"
#include "document/readdocument.h"
#include "language/language.h"
#include "report/words/findingtext.h"

#include <QTest>

using namespace palmer;

namespace {

/// Makes every questioned value of a test impossible and counts them.
class Spoiler {
public:
    template <class T>
    void operator()(const char * /*key*/, T &member, unsigned demands = nothing) {
        spoil(member, demands == nothing ? m_inherited : demands);
    }
    void object(const char * /*key*/, const auto &members) { members(*this); }
    void extensions(const char * /*key*/, const std::string & /*text*/) {}

    [[nodiscard]] int spoiled() const { return m_spoiled; }

private:
    template <class T>
    void spoil(T &member, unsigned demands) {
        if constexpr (std::is_class_v<T> && requires { fields(*this, member); }) {
            const unsigned before = std::exchange(m_inherited, demands);
            fields(*this, member);
            m_inherited = before;
        }
    }
    template <class T>
    void spoil(std::vector<T> &members, unsigned demands) {
        if constexpr (std::is_same_v<T, double>) {
            if ((demands & ascending) != 0 && members.size() > 1) {
                std::ranges::reverse(members);
                ++m_spoiled;
            }
        } else if constexpr (std::is_class_v<T>) {
            for (T &member : members)
                spoil(member, demands);
        }
    }
    template <class T>
    void spoil(std::optional<T> &member, unsigned demands) {
        if constexpr (std::is_same_v<T, double>) {
            if ((demands & questioned) != 0) {
                member = (demands & coefficient) != 0 ? 1.15e-5 : -1;
                ++m_spoiled;
            }
        } else if (member) {
            spoil(*member, demands);
        }
    }

    unsigned m_inherited = nothing;
    int m_spoiled = 0;
};

Document complete() {
    return readDocument(completeFile());
}

QString said(const Test &test, Language::Id id) {
    const Language language(id);
    QStringList sentences;
    for (const Finding &finding : findImpossible(test))
        sentences << findingText(finding, language);
    return sentences.join('\n');
}

Test positioning(void (*edit)(PositioningMeasurement &)) {
    Test test;
    test.edition = "ISO 230-2:2014";
    PositioningMeasurement measurement;
    edit(measurement);
    test.measurement = std::move(measurement);
    return test;
}

} // namespace

class ImpossibleValuesTest : public QObject {
    Q_OBJECT

private slots:
    void aSoundFileHasNone() {
        for (const TestPointer &test : complete().tests)
            QCOMPARE(impossibleValues(*test).size(), std::size_t(0));
    }

    void everyQuestionedFieldIsNamed() {
        const Document document = complete();
        int all = 0;
        for (const TestPointer &test : document.tests) {
            Test edited = *test;
            Spoiler spoiler;
            fields(spoiler, edited);
            const std::vector<ImpossibleValue> found = impossibleValues(edited);
            QCOMPARE(static_cast<int>(found.size()), spoiler.spoiled());
            for (const ImpossibleValue &impossible : found) {
                const Message &message = impossible.finding.message;
                if (const auto *name = std::get_if<Text>(&message.arguments.front()))
                    QVERIFY2(!name->empty(), impossible.place.c_str());
                const QString sentence = findingText(impossible.finding, Language(Language::Id::english));
                QVERIFY2(sentence.startsWith("Impossible value"), qPrintable(sentence));
                QVERIFY2(sentence.contains("−1") || sentence.contains(" fall from ") ||
                             sentence.contains("0.0000115"),
                         qPrintable(sentence));
            }
            all += spoiler.spoiled();
        }
        QVERIFY2(all > 25, qPrintable(QString::number(all)));
    }

    void theSentenceNamesStatementAndValue_data() {
        QTest::addColumn<Test>("test");
        QTest::addColumn<QString>("english");
        QTest::addColumn<QString>("french");
        const auto row = [](const char *name, void (*edit)(PositioningMeasurement &), const char *english,
                            const char *french) {
            QTest::newRow(name) << positioning(edit) << QString(english) << QString(french);
        };
        row(
            "humidity", [](PositioningMeasurement &m) { m.conditions.airHumidity = 130; },
            "Impossible value for “Relative humidity”: 130 %.",
            "Valeur impossible pour « Humidité relative » : 130 %.");
        row(
            "rotary feed",
            [](PositioningMeasurement &m) {
                m.axis.motion = Motion::rotary;
                m.conditions.feed = -360;
            },
            "Impossible value for “Feed rate”: −360 °/min.",
            "Valeur impossible pour « Vitesse d’avance » : −360 °/min.");
        row(
            "instrument", [](PositioningMeasurement &m) { m.uncertainty.device.fixed = -1; },
            "Impossible value for “fixed part of the instrument”: −1 µm.",
            "Valeur impossible pour « part fixe de l’instrument » : −1 µm.");
        row(
            "expansion", [](PositioningMeasurement &m) { m.conditions.common.expansion.machine = 11.5e-6; },
            "Impossible value for “coefficient of thermal expansion of the machine”: 0.0000115 µm/(m·°C).",
            "Valeur impossible pour « coefficient de dilatation thermique de la machine » : "
            "0,0000115 µm/(m·°C).");
        row(
            "expansion of glass ceramics",
            [](PositioningMeasurement &m) {
                m.conditions.common.expansion = {0.02, 0};
            },
            "", "");
        row(
            "times",
            [](PositioningMeasurement &m) {
                Sensor sensor;
                sensor.series = TemperatureSeries{{0, 60, 30}, {20, 20, 20}};
                m.conditions.common.sensors = {sensor, sensor};
                m.conditions.common.sensors[0].series.reset();
            },
            "Impossible value: the times of the temperatures of sensor 2 fall from 60 s to 30 s.",
            "Valeur impossible : les temps des températures du capteur 2 reculent de 60 s à 30 s.");
    }
    void theSentenceNamesStatementAndValue() {
        QFETCH(const Test, test);
        const auto plain = [](QString text) {
            return text.replace(QChar(0xa0), u' ').replace(QChar(0x202f), u' ');
        };
        QTEST(plain(said(test, Language::Id::english)), "english");
        QTEST(plain(said(test, Language::Id::french)), "french");
    }

    void theFileIsReadAndSaysIt() {
        QByteArray file = completeFile();
        file.replace(R"("airHumidity": 45.0)", R"("airHumidity": 145.0)");
        file.replace(R"("times": [0.0, 10.0])", R"("times": [10.0, 0.0])");
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(readDocument(file)));
        const auto count = [&](std::size_t test) {
            return std::ranges::count(evaluated.tests[test]->findings, std::string("impossibleValue"),
                                      &Finding::id);
        };
        QCOMPARE(count(0), 1);
        QCOMPARE(count(1), 0);
        QCOMPARE(count(2), 1);
    }
};

Q_DECLARE_METATYPE(palmer::Test)

QTEST_GUILESS_MAIN(ImpossibleValuesTest)
#include "impossiblevalues.moc"
