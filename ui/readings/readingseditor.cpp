// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/readingseditor.h"

#include "editing/typedreading.h"
#include "kernel/measurement/readingsaside.h"
#include "ui/model/editname.h"

#include <algorithm>
#include <iterator>

namespace palmer::ui {

ReadingsEditor::ReadingsEditor(DocumentModel &model, QObject *parent)
    : QObject(parent)
    , m_model(model) {}

const PositioningMeasurement *ReadingsEditor::measurement() const {
    return measured<PositioningMeasurement>(*m_model.document(), m_test);
}

void ReadingsEditor::edit(const char *name, const std::function<void(PositioningMeasurement &)> &change) {
    m_model.edit(name, [&](Document &document) { editReadings(document, m_test, change); });
}

void ReadingsEditor::type(const ReadingPlace &place, const QString &text, ReadingUnit unit,
                          const Language &language) {
    const PositioningMeasurement *now = measurement();
    if (!now || place.target >= now->targets.size() || excludedAt(*now, place))
        return;
    const bool positions = unit == ReadingUnit::positions;
    const NumberEntry typed =
        typedReading(text, now->axis, language.units(),
                     positions ? std::optional(now->targets[place.target]) : std::nullopt);
    edit(QT_TRANSLATE_NOOP("edits", "type a reading"), [&](PositioningMeasurement &m) {
        if (!typed.refusal)
            setReading(m, place, typed.value);
        else
            setRefused(m, place, text.trimmed().toStdString());
    });
}

std::optional<Message> ReadingsEditor::typeTarget(std::size_t target, const QString &text,
                                                  const Language &language) {
    const PositioningMeasurement *now = measurement();
    if (!now || target >= now->targets.size())
        return std::nullopt;
    const TargetEntry typed = typedTarget(text, *now, target, language.units());
    if (!typed.value)
        return typed.refusal;
    edit(QT_TRANSLATE_NOOP("edits", "move a target"),
         [&](PositioningMeasurement &m) { setTarget(m, target, *typed.value); });
    return std::nullopt;
}

std::vector<ReadingPlace> ReadingsEditor::notAside(const std::vector<ReadingPlace> &places) const {
    std::vector<ReadingPlace> result;
    const PositioningMeasurement *now = measurement();
    if (!now)
        return result;
    const ReadingsAside aside(*now);
    std::ranges::copy_if(places, std::back_inserter(result),
                         [&](const ReadingPlace &place) { return !aside.at(place.run, place.target); });
    return result;
}

void ReadingsEditor::makeMissing(const char *counted, const std::vector<ReadingPlace> &places) {
    const std::vector<ReadingPlace> free = notAside(places);
    edit(countedEdit(counted, static_cast<int>(free.size())), [&](PositioningMeasurement &m) {
        for (const ReadingPlace &place : free)
            setReading(m, place, std::nullopt);
    });
}

void ReadingsEditor::clear(const std::vector<ReadingPlace> &places) {
    makeMissing(QT_TRANSLATE_N_NOOP("edits", "clear %n reading(s)"), places);
}

void ReadingsEditor::cut(const std::vector<ReadingPlace> &places) {
    makeMissing(QT_TRANSLATE_N_NOOP("edits", "cut %n reading(s)"), places);
}

void ReadingsEditor::setAside(const std::vector<ReadingPlace> &places, const QString &reason) {
    edit(
        countedEdit(QT_TRANSLATE_N_NOOP("edits", "set %n reading(s) aside"), static_cast<int>(places.size())),
        [&](PositioningMeasurement &m) { palmer::setAside(m, places, reason.trimmed().toStdString()); });
}

void ReadingsEditor::bringBack(const std::vector<ReadingPlace> &places) {
    edit(
        countedEdit(QT_TRANSLATE_N_NOOP("edits", "take %n reading(s) back"), static_cast<int>(places.size())),
        [&](PositioningMeasurement &m) { palmer::bringBack(m, places); });
}

bool ReadingsEditor::fill(const std::vector<std::vector<ReadingPlace>> &lists) {
    std::vector<std::pair<ReadingPlace, double>> filled;
    bool any = false;
    for (const auto &places : lists) {
        const auto source =
            measurement() && !places.empty() ? readingAt(*measurement(), places.front()) : std::nullopt;
        if (!source)
            continue;
        any = true;
        for (const ReadingPlace &place : notAside({places.begin() + 1, places.end()}))
            filled.emplace_back(place, *source);
    }
    edit(countedEdit(QT_TRANSLATE_N_NOOP("edits", "fill %n reading(s)"), static_cast<int>(filled.size())),
         [&](PositioningMeasurement &m) {
             for (const auto &[place, value] : filled)
                 setReading(m, place, value);
         });
    return any;
}

std::optional<PastedBlock> ReadingsEditor::paste(const QString &text, const BlockPlace &place,
                                                 const BlockChoices &choices) {
    if (!measurement())
        return std::nullopt;
    PastedBlock pasted = pasteBlock(*measurement(), text.toStdString(), place, choices);
    const QByteArray name = pasted.readings > 0
                                ? countedEdit(QT_TRANSLATE_N_NOOP("edits", "paste of %n reading(s)"),
                                              static_cast<int>(pasted.readings))
                                : QByteArray(QT_TRANSLATE_NOOP("edits", "paste a block"));
    edit(name.constData(), [&](PositioningMeasurement &m) { m = pasted.measurement; });
    return pasted;
}

void ReadingsEditor::insertTarget(std::size_t before) {
    edit(QT_TRANSLATE_NOOP("edits", "insert a target"),
         [&](PositioningMeasurement &m) { palmer::insertTarget(m, before); });
}

void ReadingsEditor::removeTargets(const std::vector<std::size_t> &targets) {
    edit(countedEdit(QT_TRANSLATE_N_NOOP("edits", "delete %n target(s)"), static_cast<int>(targets.size())),
         [&](PositioningMeasurement &m) { palmer::removeTargets(m, targets); });
}

void ReadingsEditor::addRuns() {
    edit(QT_TRANSLATE_NOOP("edits", "add a run"), [](PositioningMeasurement &m) { palmer::addRuns(m); });
}

void ReadingsEditor::insertRun(std::size_t before, Direction approach) {
    edit(QT_TRANSLATE_NOOP("edits", "insert a run"),
         [&](PositioningMeasurement &m) { palmer::insertRun(m, before, approach); });
}

void ReadingsEditor::removeRuns(const std::vector<std::size_t> &runs) {
    edit(countedEdit(QT_TRANSLATE_N_NOOP("edits", "delete %n run(s)"), static_cast<int>(runs.size())),
         [&](PositioningMeasurement &m) { palmer::removeRuns(m, runs); });
}

} // namespace palmer::ui
