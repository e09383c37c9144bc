// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/positioning.h"
#include "ui/model/page.h"

#include <QObject>
#include <QString>
#include <cstddef>
#include <optional>

namespace palmer::ui {

using palmer::ReadingPlace;

/// The user's selection in one window, shared by its pages, figure and results so that a choice in one shows
/// in the others. It is not part of the document and not undoable. Setting the current value again emits
/// nothing. Indices count from 0; views check that they exist.
class Selection : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Index of the test in view. Choosing another one clears target, readings and parameter.
    [[nodiscard]] std::size_t test() const { return m_test; }
    void setTest(std::size_t test);

    /// The page in view in the middle of the window.
    [[nodiscard]] Page page() const { return m_page; }
    void setPage(Page page);

    /// The current target; making a reading current makes its target current.
    [[nodiscard]] std::optional<std::size_t> target() const { return m_target; }
    void setTarget(std::optional<std::size_t> target);

    /// The current cell of the readings table.
    [[nodiscard]] std::optional<ReadingPlace> reading() const { return m_reading; }
    void setReading(std::optional<ReadingPlace> reading);

    /// The reading under the pointer, in the figure or table.
    [[nodiscard]] std::optional<ReadingPlace> hovered() const { return m_hovered; }
    void setHovered(std::optional<ReadingPlace> reading);

    /// ID of the parameter being explained, as in parameterId ("A", "G(b)_XY"); empty if none.
    [[nodiscard]] QString parameter() const { return m_parameter; }
    void setParameter(const QString &id);

    /// ID of the finding whose statement is to be shown; empty if none. Setting it again emits again.
    [[nodiscard]] QString field() const { return m_field; }
    void setField(const QString &id);

signals:
    void testChanged(std::size_t test);
    void pageChanged(palmer::ui::Page page);
    void targetChanged();
    void readingChanged();
    void hoveredChanged();
    void parameterChanged();
    void fieldChosen(const QString &id);

private:
    std::size_t m_test = 0;
    Page m_page = Page::readings;
    std::optional<std::size_t> m_target;
    std::optional<ReadingPlace> m_reading;
    std::optional<ReadingPlace> m_hovered;
    QString m_parameter;
    QString m_field;
};

} // namespace palmer::ui
