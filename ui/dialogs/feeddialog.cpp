#include "ui/dialogs/feeddialog.h"

#include "language/decimals.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace palmer::ui {

namespace {

constexpr double smallest = 0.001;
constexpr double largestDiameter = 100'000; ///< mm
constexpr double largestFeed = 1'000'000;   ///< mm/min
constexpr int digits = 3;
constexpr int margin = 16;
constexpr iso230_4::ContouringFeed exampleOfTheAnnex{100, 500, 125};

/// Shows no zeros that nobody entered: 100, not 100.000.
class NumberBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    [[nodiscard]] QString textFromValue(double value) const override {
        QString text = QDoubleSpinBox::textFromValue(value);
        const QString point = locale().decimalPoint();
        if (text.contains(point)) {
            while (text.endsWith(u'0'))
                text.chop(1);
            if (text.endsWith(point))
                text.chop(point.size());
        }
        return text;
    }
};

} // namespace

FeedDialog::FeedDialog(QWidget *parent)
    : QDialog(parent)
    , m_specifiedDiameterLabel(new QLabel(this))
    , m_specifiedFeedLabel(new QLabel(this))
    , m_diameterLabel(new QLabel(this))
    , m_specifiedDiameter(addNumber("specifiedDiameter", largestDiameter))
    , m_specifiedFeed(addNumber("specifiedFeed", largestFeed))
    , m_diameter(addNumber("diameter", largestDiameter))
    , m_feedLabel(new QLabel(this))
    , m_feed(new QLabel(this))
    , m_formula(new QLabel(this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Close, this)) {
    setObjectName(QStringLiteral("feedDialog"));
    m_specifiedDiameterLabel->setBuddy(m_specifiedDiameter);
    m_specifiedFeedLabel->setBuddy(m_specifiedFeed);
    m_diameterLabel->setBuddy(m_diameter);
    m_feed->setObjectName(QStringLiteral("feed"));
    m_feed->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_feed->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_formula->setProperty("secondary", true);

    auto *form = new QFormLayout;
    form->setLabelAlignment(Qt::AlignLeft);
    form->addRow(m_specifiedDiameterLabel, m_specifiedDiameter);
    form->addRow(m_specifiedFeedLabel, m_specifiedFeed);
    form->addRow(m_diameterLabel, m_diameter);
    form->addRow(m_feedLabel, m_feed);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(margin);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    layout->addLayout(form);
    layout->addWidget(m_formula);
    layout->addWidget(m_buttons);
    for (QDoubleSpinBox *box : {m_specifiedDiameter, m_specifiedFeed, m_diameter})
        connect(box, &QDoubleSpinBox::valueChanged, this, &FeedDialog::showFeed);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setNumbers(exampleOfTheAnnex);
    retranslate();
}

QDoubleSpinBox *FeedDialog::addNumber(const char *name, double largest) {
    auto *box = new NumberBox(this);
    box->setObjectName(QLatin1StringView(name));
    box->setDecimals(digits);
    box->setRange(smallest, largest);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setGroupSeparatorShown(true);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAlignment(Qt::AlignRight);
    return box;
}

void FeedDialog::setNumbers(const iso230_4::ContouringFeed &numbers) {
    const auto set = [](QDoubleSpinBox *box, double value) {
        if (value > 0)
            box->setValue(value);
    };
    set(m_specifiedDiameter, numbers.specifiedDiameter);
    set(m_specifiedFeed, numbers.specifiedFeed);
    set(m_diameter, numbers.diameter);
    showFeed();
}

void FeedDialog::showFeed() {
    const auto feed = iso230_4::contouringFeed(
        {m_specifiedDiameter->value(), m_specifiedFeed->value(), m_diameter->value()});
    m_feed->setText(feed ? windowLanguage().quantity(*feed, Quantity::feed, feedDecimals(*feed))
                         : QStringLiteral("–"));
}

void FeedDialog::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void FeedDialog::retranslate() {
    setWindowTitle(tr("Contouring feed"));
    m_specifiedDiameterLabel->setText(tr("Specified &diameter d₂"));
    m_specifiedFeedLabel->setText(tr("Specified &feed V₂"));
    m_diameterLabel->setText(tr("Diameter of the &test d₁"));
    m_feedLabel->setText(tr("Feed of the test V₁"));
    m_feedLabel->setFont(themeFont(TextSize::head));
    m_feed->setFont(themeFont(TextSize::head));
    m_feed->setAccessibleName(m_feedLabel->text());
    m_formula->setFont(themeFont(TextSize::small));
    m_formula->setText(QStringLiteral("V₁ = V₂·√(d₁/d₂)   ") + tr("ISO 230-4, annex C"));
    m_buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    const QLocale locale(windowLanguage().id() == Language::Id::french ? QLocale::French : QLocale::English);
    for (QDoubleSpinBox *box : {m_specifiedDiameter, m_specifiedFeed, m_diameter}) {
        const Quantity quantity = box == m_specifiedFeed ? Quantity::feed : Quantity::position;
        box->setLocale(locale);
        box->setSuffix(QStringLiteral("\u00A0") + windowLanguage().unit(quantity));
    }
    showFeed();
}

} // namespace palmer::ui
