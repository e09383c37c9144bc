// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/editreadings.h"
#include "editing/readingblock.h"
#include "language/language.h"
#include "report/tables/readingtable.h"
#include "ui/model/documentmodel.h"

#include <QObject>
#include <QString>
#include <vector>

namespace palmer::ui {

/// The user's edits of the readings of the current test, each as one named undo step. Does nothing if that is
/// not a positioning test. An excluded reading keeps its value and reason, whatever is typed, deleted, filled
/// or pasted over it, until it is restored.
class ReadingsEditor : public QObject {
    Q_OBJECT

public:
    ReadingsEditor(DocumentModel &model, QObject *parent = nullptr);

    void setTest(std::size_t test) { m_test = test; }
    [[nodiscard]] std::size_t test() const { return m_test; }
    [[nodiscard]] DocumentModel &model() { return m_model; }
    /// The current measurement, before evaluation; may be null.
    [[nodiscard]] const PositioningMeasurement *measurement() const;

    /// Sets a text typed into a cell, in the cell's unit. Text that is not a number is kept as typed.
    void type(const ReadingPlace &place, const QString &text, ReadingUnit unit, const Language &language);

    /// Sets a target position; returns null, or why the text is invalid.
    [[nodiscard]] std::optional<Message> typeTarget(std::size_t target, const QString &text,
                                                    const Language &language);

    void clear(const std::vector<ReadingPlace> &places);
    void cut(const std::vector<ReadingPlace> &places); ///< as clear(), as a step with another name
    void setAside(const std::vector<ReadingPlace> &places, const QString &reason);
    void bringBack(const std::vector<ReadingPlace> &places);
    /// Copies the reading at the first place of each list to the others. False if there is none in any list.
    bool fill(const std::vector<std::vector<ReadingPlace>> &lists);

    /// Pastes a block as one step. Throws what pasteBlock throws. Null if there is no positioning test.
    std::optional<PastedBlock> paste(const QString &text, const BlockPlace &place,
                                     const BlockChoices &choices);

    void insertTarget(std::size_t before);
    void removeTargets(const std::vector<std::size_t> &targets);
    void addRuns();
    void insertRun(std::size_t before, Direction approach);
    void removeRuns(const std::vector<std::size_t> &runs);

private:
    [[nodiscard]] std::vector<ReadingPlace> notAside(const std::vector<ReadingPlace> &places) const;
    void makeMissing(const char *counted, const std::vector<ReadingPlace> &places);
    void edit(const char *name, const std::function<void(PositioningMeasurement &)> &change);

    DocumentModel &m_model;
    std::size_t m_test = 0;
};

} // namespace palmer::ui
