// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

#include <QAnyStringView>
#include <QBoxLayout>
#include <QMargins>
#include <QScrollArea>
#include <QWidget>
#include <concepts>
#include <initializer_list>
#include <utility>

namespace palmer::ui {

/// Returns a new object, usually a widget, made from `arguments`, with an object name.
template <class Object, class... Arguments>
[[nodiscard]] Object *made(QAnyStringView name, Arguments &&...arguments) {
    auto *object = new Object(std::forward<Arguments>(arguments)...);
    if (!name.isEmpty())
        object->setObjectName(name);
    return object;
}

/// Properties that made() gives a widget besides its name and text size.
namespace trait {
inline constexpr auto secondary = [](QWidget &widget) { widget.setProperty("secondary", true); }; ///< dimmed
/// Says why something is refused.
inline constexpr auto reason = [](QWidget &widget) { widget.setProperty("reason", true); };
inline constexpr auto link = [](QWidget &button) { button.setProperty("link", true); };
inline constexpr auto primary = [](QWidget &button) { button.setProperty("primary", true); };
inline constexpr auto iconOnly = [](QWidget &button) { button.setProperty("iconOnly", true); };
inline constexpr auto wrapped = [](auto &label) { label.setWordWrap(true); };
/// For a text that may look like markup.
inline constexpr auto plainText = [](auto &label) { label.setTextFormat(Qt::PlainText); };
inline constexpr auto checkable = [](auto &button) { button.setCheckable(true); };
inline constexpr auto notDefault = [](auto &button) { button.setAutoDefault(false); };
inline constexpr auto strongFocus = [](QWidget &widget) { widget.setFocusPolicy(Qt::StrongFocus); };
/// For a button in a row of joined ones; `place`: first, middle, last or only.
inline auto segment(const char *place) {
    return [place](QWidget &button) { button.setProperty("segment", QString::fromLatin1(place)); };
}
/// For an area that scrolls its content up and down only, without frame and focus.
inline constexpr auto scrollsDown = [](QScrollArea &area) {
    area.setWidgetResizable(true);
    area.setFrameShape(QFrame::NoFrame);
    area.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area.setFocusPolicy(Qt::NoFocus);
};
} // namespace trait

/// Returns a new widget with an object name and a trait; further traits may follow before its arguments.
template <class Widget, std::invocable<Widget &> Trait, class... Arguments>
[[nodiscard]] Widget *made(QAnyStringView name, Trait set, Arguments &&...arguments) {
    auto *widget = made<Widget>(name, std::forward<Arguments>(arguments)...);
    set(*widget);
    return widget;
}

/// Returns a new widget with an object name and a text size of the theme; traits may follow.
template <class Widget, class... Arguments>
[[nodiscard]] Widget *made(QAnyStringView name, TextSize size, Arguments &&...arguments) {
    auto *widget = made<Widget>(name, std::forward<Arguments>(arguments)...);
    widget->setFont(themeFont(size));
    return widget;
}

/// Returns a new widget with a text size or a trait, without a name.
template <class Widget, class... Arguments>
[[nodiscard]] Widget *made(TextSize size, Arguments &&...arguments) {
    return made<Widget>(QAnyStringView(), size, std::forward<Arguments>(arguments)...);
}
template <class Widget, std::invocable<Widget &> Trait, class... Arguments>
[[nodiscard]] Widget *made(Trait set, Arguments &&...arguments) {
    return made<Widget>(QAnyStringView(), set, std::forward<Arguments>(arguments)...);
}

/// Says to the pointer and to screen readers what a widget without words does; `keys`: its shortcut.
inline void nameWidget(QWidget &widget, const QString &text, const QString &keys = {}) {
    widget.setAccessibleName(text);
    widget.setToolTip(keys.isEmpty() ? text : text + QStringLiteral(" (") + keys + u')');
}

/// Item of a row or column: a widget or a layout with its stretch factor, a gap in pixels, or a
/// stretch.
class Placed {
public:
    Placed(QWidget *widget, int stretch = 0, Qt::Alignment alignment = {})
        : m_widget(widget)
        , m_stretch(stretch)
        , m_alignment(alignment) {}
    Placed(QLayout *layout, int stretch = 0)
        : m_layout(layout)
        , m_stretch(stretch) {}

    [[nodiscard]] static Placed gap(int pixels) { return {false, pixels}; }
    [[nodiscard]] static Placed stretch(int factor = 0) { return {true, factor}; }

    void addTo(QBoxLayout &layout) const {
        if (m_widget)
            layout.addWidget(m_widget, m_stretch, m_alignment);
        else if (m_layout)
            layout.addLayout(m_layout, m_stretch);
        else if (m_isStretch)
            layout.addStretch(m_stretch);
        else
            layout.addSpacing(m_gap);
    }

private:
    Placed(bool isStretch, int size)
        : m_stretch(isStretch ? size : 0)
        , m_gap(isStretch ? 0 : size)
        , m_isStretch(isStretch) {}

    QWidget *m_widget = nullptr;
    QLayout *m_layout = nullptr;
    int m_stretch = 0;
    int m_gap = 0;
    Qt::Alignment m_alignment;
    bool m_isStretch = false;
};

inline constexpr int styleSpacing = -1;                 ///< the style decides
inline constexpr QMargins styleMargins{-1, -1, -1, -1}; ///< the style decides; none if the layout is nested
inline constexpr QMargins noMargins{0, 0, 0, 0};

/// Returns a new layout with its parts in their order; `parent` may be null.
template <class Box>
Box *filled(QWidget *parent, const QMargins &margins, int spacing, std::initializer_list<Placed> parts) {
    auto *layout = new Box(parent);
    layout->setContentsMargins(margins);
    layout->setSpacing(spacing);
    for (const Placed &part : parts)
        part.addTo(*layout);
    return layout;
}

/// Lays out the parts of `parent` from left to right; null: the row is to be nested in another layout.
inline QHBoxLayout *inRow(QWidget *parent, const QMargins &margins, int spacing,
                          std::initializer_list<Placed> parts) {
    return filled<QHBoxLayout>(parent, margins, spacing, parts);
}

/// Returns a row without margins to be nested in another layout.
[[nodiscard]] inline QHBoxLayout *inRow(int spacing, std::initializer_list<Placed> parts) {
    return filled<QHBoxLayout>(nullptr, styleMargins, spacing, parts);
}

/// Lays out the parts of `parent` from top to bottom; null: the column is to be nested in another layout.
inline QVBoxLayout *inColumn(QWidget *parent, const QMargins &margins, int spacing,
                             std::initializer_list<Placed> parts) {
    return filled<QVBoxLayout>(parent, margins, spacing, parts);
}

/// Returns a column without margins to be nested in another layout.
[[nodiscard]] inline QVBoxLayout *inColumn(int spacing, std::initializer_list<Placed> parts) {
    return filled<QVBoxLayout>(nullptr, styleMargins, spacing, parts);
}

} // namespace palmer::ui
