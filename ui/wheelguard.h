// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace palmer::ui {

/// From now on the wheel changes no field that does not have the focus: it scrolls what the field stands in.
void guardWheel(QApplication &application);

} // namespace palmer::ui
