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

/// What a user does to the readings of the test in view, each as one named step to undo. Does nothing where
/// that test is no positioning test. A reading set aside keeps value and reason, whatever is typed, deleted,
/// filled or pasted over it, until it is taken back.
class ReadingsEditor : public QObject {
    Q_OBJECT

public:
    ReadingsEditor(DocumentModel &model, QObject *parent = nullptr);

    void setTest(std::size_t test) { m_test = test; }
    [[nodiscard]] std::size_t test() const { return m_test; }
    [[nodiscard]] DocumentModel &model() { return m_model; }
    /// The measurement as it is now, before it is evaluated; null where there is none.
    [[nodiscard]] const PositioningMeasurement *measurement() const;

    /// A text typed into a cell, in the unit the cell shows. What is no number is kept as it was typed.
    void type(const ReadingPlace &place, const QString &text, ReadingUnit unit, const Language &language);

    /// A target position typed; null, or why it cannot be one.
    [[nodiscard]] std::optional<Message> typeTarget(std::size_t target, const QString &text,
                                                    const Language &language);

    void clear(const std::vector<ReadingPlace> &places);
    void cut(const std::vector<ReadingPlace> &places); ///< the same under another name
    void setAside(const std::vector<ReadingPlace> &places, const QString &reason);
    void bringBack(const std::vector<ReadingPlace> &places);
    /// The reading at the first place of each list is put into the others; false: there is none at any.
    bool fill(const std::vector<std::vector<ReadingPlace>> &lists);

    /// Puts a block in, as one step: the former one, if it was the last thing done, is taken back before
    /// (`instead`). Throws what pasteBlock throws. Null where there is no test.
    std::optional<PastedBlock> paste(const QString &text, const BlockPlace &place,
                                     const BlockChoices &choices, bool instead = false);

    /// Whether the paste was the last thing done, and can be taken back as such.
    [[nodiscard]] bool isPasteLast() const;
    void undoPaste();

    void insertTarget(std::size_t before);
    void removeTargets(const std::vector<std::size_t> &targets);
    void addRuns();
    void insertRun(std::size_t before, Direction approach);
    void removeRuns(const std::vector<std::size_t> &runs);

signals:
    /// A step was made, undone or redone, here or elsewhere.
    void stepped();

private:
    [[nodiscard]] std::vector<ReadingPlace> notAside(const std::vector<ReadingPlace> &places) const;
    void makeMissing(const char *counted, const std::vector<ReadingPlace> &places);
    void edit(const char *name, const std::function<void(PositioningMeasurement &)> &change);

    DocumentModel &m_model;
    std::size_t m_test = 0;
    int m_pasteIndex = -1; ///< of the undo stack, after the last paste
};

} // namespace palmer::ui
