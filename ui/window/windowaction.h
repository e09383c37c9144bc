// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace palmer::ui {

/// The menus of the window; `bar` holds those that are always in sight.
enum class WindowMenu { none, bar, file, recent, examples, exports, edit, test, view, units, tools, help };
inline constexpr std::size_t windowMenus = static_cast<std::size_t>(WindowMenu::help) + 1;

/// What its menus offer; the table that says how is in mainwindowactions.cpp. `afterReadings` and
/// `afterCircles` are lines behind what pages bring with them.
enum class WindowAction {
    none,
    newTest,
    newCircle,
    open,
    import,
    importClipboard,
    save,
    saveAs,
    report,
    exportReadings,
    exportFigure,
    compensation,
    newWindow,
    close,
    quit,
    undo,
    redo,
    addTest,
    addCircle,
    addDrift,
    renameTest,
    duplicateTest,
    repeatTest,
    deleteTest,
    afterReadings,
    afterCircles,
    previousTest,
    nextTest,
    setEdition,
    ownEdition,
    readingsPage,
    conditionsPage,
    agreedPointsPage,
    limitsPage,
    uncertaintyPage,
    diagnosisPage,
    nextMissing,
    previousMissing,
    nextPane,
    previousPane,
    maximiseFigure,
    micrometres,
    millimetres,
    inches,
    arcSeconds,
    degrees,
    french,
    english,
    plan,
    compare,
    feed,
    allTests,
    settings,
    help,
    shortcuts,
    validation,
    about,
    aboutQt
};
inline constexpr std::size_t windowActions = static_cast<std::size_t>(WindowAction::aboutQt) + 1;

} // namespace palmer::ui
