#pragma once

#include "ui/forms/form.h"

namespace palmer::ui {

/// The head of the report: number, dates, laboratory, customer, who signs.
class IdentificationPage : public Form {
    Q_OBJECT

public:
    explicit IdentificationPage(QWidget *parent = nullptr);
};

} // namespace palmer::ui
