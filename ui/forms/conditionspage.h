#pragma once

#include "ui/forms/form.h"

namespace palmer::ui {

/// Under which conditions a test was made: temperatures, cycle, positions.
class ConditionsPage : public Form {
    Q_OBJECT

public:
    explicit ConditionsPage(Selection &selection, QWidget *parent = nullptr);
};

} // namespace palmer::ui
