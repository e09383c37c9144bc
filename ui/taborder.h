// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;
class QWidget;

namespace palmer::ui {

/// Lets Tab walk what stands in the window in the order of its layouts, which is that of reading, and not in
/// the order in which its parts were made. It has a layout; what stands in no layout keeps its place.
void orderTabs(QWidget &window);

/// Does so for each dialog when it is shown first.
void orderTabsOfDialogs(QApplication &application);

} // namespace palmer::ui
