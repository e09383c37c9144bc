#pragma once

#include "report/report.h"

#include <QIODevice>

namespace palmer::ui {

/// Writes the report as a PDF: vectors and text, fonts embedded, with title and language. The same report
/// gives the same bytes at any time, place and locale, provided QHashSeed::setDeterministicGlobalSeed() was
/// called before the QApplication. Throws Error(unwritable) when the device does not take all.
void writePdf(const Report &report, QIODevice &device);

} // namespace palmer::ui
