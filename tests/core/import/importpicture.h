// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/importmeasurement.h"
#include "kernel/measurement/testfacts.h"
#include "language/language.h"

#include <QString>
#include <QStringList>

namespace palmer::testdata {

/// A measurement as lines of text: what was read, exactly, in the units people use (µm; rotary: degrees).
inline QString picture(const Imported &imported) {
    const auto number = [](double value, int digits = 10) {
        return QString::number(value + 0.0, 'g', digits);
    };
    QStringList lines;
    if (imported.test) {
        const Test &test = *imported.test;
        if (const auto *m = std::get_if<PositioningMeasurement>(&test.measurement)) {
            QStringList targets;
            for (const double target : m->targets)
                targets << number(target);
            lines << QStringLiteral("%1 %2 %3: %4")
                         .arg(QString::fromStdString(test.edition), QString::fromStdString(m->axis.name),
                              m->axis.motion == Motion::rotary ? QStringLiteral("°") : QStringLiteral("mm"),
                              targets.join(u' '));
            for (const Run &run : m->runs) {
                QStringList values;
                for (const auto &value : run.deviations) {
                    if (!value)
                        values << QStringLiteral("–");
                    else
                        values << number(m->axis.motion == Motion::rotary ? *value : *value * 1000, 7);
                }
                lines << (run.approach == Direction::positive ? QStringLiteral("↑ ") : QStringLiteral("↓ ")) +
                             values.join(u' ');
            }
        } else if (const auto *c = std::get_if<CircularMeasurement>(&test.measurement)) {
            lines << QStringLiteral("%1 %2%3 R %4 mm F %5")
                         .arg(QString::fromStdString(test.edition), QString::fromStdString(c->plane.first),
                              QString::fromStdString(c->plane.second), number(c->nominalRadius),
                              c->feed ? number(*c->feed) : QStringLiteral("–"));
            for (const Arc &arc : c->arcs) {
                QStringList values;
                for (std::size_t i = 0; i < std::min<std::size_t>(arc.angles.size(), 12); ++i)
                    values << number(arc.angles[i], 8) + u':' +
                                  number(std::round(arc.radialDeviations[i] * 1e7) / 1e4, 7);
                lines << QStringLiteral("%1 %2 %3: %4")
                             .arg(arc.sense == Sense::clockwise ? QStringLiteral("cw")
                                                                : QStringLiteral("ccw"),
                                  arc.angleReference == AngleReference::polar ? QStringLiteral("polar")
                                                                              : QStringLiteral("commanded"))
                             .arg(arc.angles.size())
                             .arg(values.join(u' '));
            }
        } else if (const auto *d = std::get_if<DriftMeasurement>(&test.measurement)) {
            const auto add = [&](const char *word, const std::string &name, double scale,
                                 const auto &series) {
                QStringList values;
                for (std::size_t i = 0; i < d->times.size(); ++i)
                    values << number(d->times[i]) + u':' +
                                  (series[i] ? number(*series[i] * scale, 7) : QStringLiteral("-"));
                lines << QStringLiteral("%1 %2 %3")
                             .arg(QLatin1StringView(word), QString::fromStdString(name), values.join(u' '));
            };
            for (const DriftChannel &channel : channelsOf(*d))
                add(d->channels.empty() ? "drift" : "channel", channel.name,
                    channel.quantity == ChannelQuantity::angularDeviation ? 1 : 1000, channel.values);
            for (const DriftTemperature &temperature : d->temperatures)
                add("temperature", temperature.measures, 1, temperature.values);
        }
    }
    for (const Sensor &sensor : imported.sensors) {
        QStringList values;
        if (!sensor.series && sensor.start)
            values << number(*sensor.start);
        for (std::size_t i = 0; sensor.series && i < sensor.series->times.size(); ++i)
            values << number(sensor.series->times[i]) + u':' + number(sensor.series->temperatures[i]);
        const char *what = sensor.measures == SensorMeasures::air         ? "air"
                           : sensor.measures == SensorMeasures::machine   ? "machine"
                           : sensor.measures == SensorMeasures::notStated ? "–"
                                                                          : "instrument";
        lines << QStringLiteral("sensor %1 %2 %3")
                     .arg(QString::fromStdString(sensor.position), QString::fromUtf8(what),
                          values.join(u' '));
    }
    return lines.join(u'\n');
}

/// The questions in English: `!!` red, `??` asked, with the choice that answers them and the proposal.
inline QString questions(const Imported &imported) {
    const Language english(Language::Id::english);
    QStringList lines;
    for (const Question &question : imported.questions)
        lines << QStringLiteral("%1 %2=%3: %4%5%6")
                     .arg(question.grade == QuestionGrade::doubtful ? QStringLiteral("!!")
                                                                    : QStringLiteral("??"),
                          QString::fromStdString(question.id), QString::fromStdString(question.proposal),
                          question.line > 0 ? QString::number(question.line) + QStringLiteral(": ")
                                            : QString(),
                          english.sentence(question.sentence),
                          question.further.empty()
                              ? QString()
                              : QStringLiteral(" (and %1 more)").arg(question.further.size()));
    return lines.join(u'\n');
}

/// The remarks in English: `!` problem, `?` assumption, `i` note, with line and column.
inline QString remarks(const Imported &imported) {
    const Language english(Language::Id::english);
    QStringList lines;
    for (const Remark &remark : imported.remarks) {
        const char16_t grade = remark.grade == RemarkGrade::problem      ? u'!'
                               : remark.grade == RemarkGrade::assumption ? u'?'
                                                                         : u'i';
        QString place;
        if (remark.line > 0)
            place = QString::number(remark.line) +
                    (remark.column > 0 ? u':' + QString::number(remark.column) : QString()) +
                    QStringLiteral(": ");
        lines << QChar(grade) + QStringLiteral(" ") + place + english.sentence(remark.message) +
                     (remark.times > 1 ? QStringLiteral(" (× %1)").arg(remark.times) : QString());
    }
    return lines.join(u'\n');
}

/// "unit=um*" for a guess, "unit=um" for what is recognised, "unit=um!" for what was chosen.
inline QString choices(const Imported &imported) {
    QStringList words;
    for (const ImportChoice &choice : imported.choices) {
        const char *mark = choice.origin == Origin::guessed  ? "*"
                           : choice.origin == Origin::chosen ? "!"
                                                             : "";
        words << QString::fromStdString(choice.key + "=" + choice.value) + QLatin1StringView(mark);
    }
    return words.join(u' ');
}

} // namespace palmer::testdata
