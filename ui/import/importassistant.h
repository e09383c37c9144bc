#pragma once

#include "figures/figure.h"
#include "import/importmeasurement.h"
#include "import/profiles.h"
#include "ui/import/rawtextmodel.h"
#include "ui/import/recognisedmodel.h"
#include "ui/model/selection.h"

#include <QDialog>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;
class QStackedWidget;
class QTableView;
class QVBoxLayout;

namespace palmer::ui {

class CircleCanvas;
class FigureCanvas;
class LineView;

/// "Import…": what a measurement file says, before anything is accepted. The text as it was read, the table
/// and the curve that come of it, every choice with how it came about, and the remarks. Another choice reads
/// the file anew. Changes no document: whoever opened it puts in what was read, with addTo().
class ImportAssistant : public QDialog {
    Q_OBJECT

public:
    /// `open`: the document that is open, to put the measurement into; null for none. Throws Error for bytes
    /// that cannot be imported.
    ImportAssistant(QByteArray bytes, const QString &fileName, const Document *open,
                    QWidget *parent = nullptr);

    [[nodiscard]] const Imported &imported() const { return m_imported; }
    /// Whether the measurement shall be a new document and not go into the open one.
    [[nodiscard]] bool wantsNewDocument() const;
    void addTo(Document &document) const;

    /// Chooses a word, number or text for a choice, as its box does; empty: what is found in the file.
    void choose(const std::string &key, const std::string &value);
    /// Takes what was guessed for a choice as said.
    void confirm(const std::string &key);
    /// Reads other bytes in the place of those at hand; what cannot be read is said, and nothing changes.
    void takeFile(const QByteArray &bytes, const QString &fileName);
    void pasteText();

    /// Keeps the choices under a name; those that the file itself says are not among them. False, and a
    /// message, when that fails.
    bool saveProfile(const QString &name);

    void accept() override;

protected:
    void changeEvent(QEvent *event) override;

private:
    struct Box {
        std::string key;
        QWidget *cell;
        QLabel *name;
        QLabel *badge;
        QComboBox *words; ///< null: typed
        QLineEdit *edit;
    };

    void makeLayout();
    void useLastProfile();
    void chooseOther();
    void takeTyped();
    void takeOptions(ImportOptions options);
    void useProfile(const QString &name);
    void fillProfiles(const QString &current);
    void askProfileName();
    [[nodiscard]] std::vector<ImportChoice> shownChoices() const;
    void makeBoxes();
    void showChoices();
    void showRemarks();
    void addQuestion(const Question &question);
    void addRemark(const Remark &remark);
    QHBoxLayout *addRow(RemarkGrade grade, QString sentence, std::size_t line, std::size_t column,
                        std::size_t times);
    void showCurve();
    void showSizes();
    void refresh();
    void refuse(const Error &error, const QString &file);
    void retranslate();

    QByteArray m_bytes;
    QString m_fileName;
    std::optional<Document> m_document; ///< the open one
    ImportOptions m_options;
    Imported m_imported;
    ImportProfiles m_profiles;
    std::optional<QString> m_refusal; ///< why the latest choices cannot be used
    Selection m_selection;
    RawTextModel m_raw;
    RecognisedModel m_recognised;
    std::optional<CurveFigure> m_curve;
    std::vector<Box> m_boxes;

    QLabel *m_title;
    QLabel *m_origin;
    QPushButton *m_other;
    QPushButton *m_paste;
    QGridLayout *m_choices;
    QLabel *m_destinationName;
    QComboBox *m_destination;
    QLabel *m_profileName;
    QComboBox *m_profile;
    QLabel *m_rawTitle;
    QLabel *m_rawSize;
    QListView *m_rawView;
    QLabel *m_tableTitle;
    QLabel *m_tableSize;
    QTableView *m_table;
    QLabel *m_curveTitle;
    QStackedWidget *m_curves;
    FigureCanvas *m_curveCanvas;
    CircleCanvas *m_circleCanvas;
    LineView *m_lineView;
    QLabel *m_noCurve;
    QLabel *m_remarksTitle;
    QVBoxLayout *m_remarks;
    QCheckBox *m_keep;
    QPushButton *m_saveProfile;
    QLabel *m_open;
    QPushButton *m_cancel;
    QPushButton *m_import;
};

} // namespace palmer::ui
