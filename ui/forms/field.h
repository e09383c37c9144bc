#pragma once

#include <QLineEdit>
#include <QString>
#include <QWidget>

class QLabel;

namespace palmer::ui {

/// A field of a form: label above, unit inside at the right, and where something required is missing a mark
/// and a bar. Empty means not stated.
class Field : public QWidget {
    Q_OBJECT

public:
    enum class Kind { text, number };

    explicit Field(Kind kind, QWidget *parent = nullptr);

    void setLabel(const QString &label);
    /// Stands for %1 in the label.
    void setLabelArgument(const QString &argument);
    void setUnit(const QString &unit);
    /// Shows a value; `required`: it is missing and the report needs it.
    void show(const QString &value, bool required);

    [[nodiscard]] QLineEdit *edit() const { return m_edit; }
    [[nodiscard]] QString text() const { return m_edit->text(); }
    [[nodiscard]] bool isRequired() const { return m_required; }

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void retranslate();
    void placeParts();

    Kind m_kind;
    bool m_required = false;
    QString m_labelSource;
    QString m_labelArgument;
    QLabel *m_label;
    QLabel *m_mark;
    QLineEdit *m_edit;
    QLabel *m_unit;
    QWidget *m_bar;
};

} // namespace palmer::ui
