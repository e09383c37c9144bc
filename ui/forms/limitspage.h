#pragma once

#include "ui/forms/form.h"

namespace palmer::ui {

class ElidedLabel;

/// The agreed limits of a test and the decision rule. Never beside a verdict.
class LimitsPage : public Form {
    Q_OBJECT

public:
    LimitsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

protected:
    void prepare() override;
    void refreshOthers() override;

private:
    /// A limit as a row of the table: what it is of, its value, edition and origin.
    struct Name {
        ElidedLabel *label = nullptr;
        QString symbol;
        Text name;
    };
    void addLimit(const Name &of, const std::string &id, Quantity quantity, Kind kind);

    std::vector<Name> m_names;
    QStringList m_built; ///< for which edition and parameters there are fields
};

} // namespace palmer::ui
