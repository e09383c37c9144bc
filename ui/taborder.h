// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

namespace palmer::ui {

/// Makes Tab follow the window's layouts, that is the reading order, instead of the order of creation. The
/// window needs a layout; widgets in no layout keep their place.
void orderTabs(QWidget &window);

/// Does this for each dialog when it is first shown.
void orderTabsOfDialogs(QApplication &application);

} // namespace palmer::ui
