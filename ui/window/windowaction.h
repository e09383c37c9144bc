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

/// What the window holds, as far as it decides which actions can be taken.
struct WindowSituation {
    bool open = false;              ///< a document
    std::size_t tests = 0;          ///< of it
    std::size_t test = 0;           ///< in view
    bool hasResults = false;        ///< the test in view, and they are of it as it is
    bool hasEdition = false;        ///< the test in view, evaluated
    bool hasTargets = false;        ///< the test in view
    bool underOtherEdition = false; ///< the test in view is shown as another edition sees it
    bool canUndo = false;
    bool canRedo = false;
};

} // namespace palmer::ui
