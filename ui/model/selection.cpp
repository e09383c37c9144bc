// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/selection.h"

namespace palmer::ui {

void Selection::setTest(std::size_t test) {
    if (m_test == test)
        return;
    setParameter({});
    setField({});
    setHovered({});
    setReading({});
    setTarget({});
    m_test = test;
    emit testChanged(test);
}

void Selection::setPage(Page page) {
    if (m_page == page)
        return;
    m_page = page;
    emit pageChanged(page);
}

void Selection::setTarget(std::optional<std::size_t> target) {
    if (m_target == target)
        return;
    m_target = target;
    emit targetChanged();
}

void Selection::setReading(std::optional<ReadingPlace> reading) {
    if (m_reading == reading)
        return;
    m_reading = reading;
    if (reading)
        setTarget(reading->target);
    emit readingChanged();
}

void Selection::setHovered(std::optional<ReadingPlace> reading) {
    if (m_hovered == reading)
        return;
    m_hovered = reading;
    emit hoveredChanged();
}

void Selection::setParameter(const QString &id) {
    if (m_parameter == id)
        return;
    m_parameter = id;
    emit parameterChanged();
}

void Selection::setField(const QString &id) {
    m_field = id;
    if (!id.isEmpty())
        emit fieldChosen(id);
}

} // namespace palmer::ui
