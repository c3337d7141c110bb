// SPDX-License-Identifier: GPL-3.0-or-later
// What the commissioning page consists of, and its words.
#include "ui/commissioning/commission_model.h"
#include "ui/commissioning/commission_page.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/tone_delegate.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int setupWidth = 320;
constexpr double headlineScale = 2.0;
constexpr int headlineLines = 2; ///< room for the longest one

/// What stands below it stays where it is when it is hidden.
void keepSizeWhenHidden(QWidget* widget)
{
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
}

/// QFormLayout keeps no room by itself.
QWidget* fixedHeightRow(QWidget* widget)
{
    keepSizeWhenHidden(widget);
    auto* room = new QWidget(widget->parentWidget());
    auto* column = new QVBoxLayout(room);
    column->setContentsMargins({});
    column->addWidget(widget);
    return room;
}
} // namespace

QPushButton* CommissionPage::button(const char* name)
{
    auto* made = new QPushButton(this);
    made->setObjectName(QString::fromLatin1(name));
    return made;
}

QWidget* CommissionPage::pathField(QLineEdit*& edit, QToolButton*& browse, const char* name)
{
    auto* box = new QWidget(m_setup);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins({});
    row->setSpacing(2);
    edit = new QLineEdit(box);
    edit->setObjectName(QString::fromLatin1(name));
    edit->setClearButtonEnabled(true);
    browse = new QToolButton(box);
    browse->setObjectName(QString::fromLatin1(name) + QStringLiteral("Browse"));
    browse->setText(QStringLiteral("…"));
    row->addWidget(edit, 1);
    row->addWidget(browse);
    return box;
}

void CommissionPage::build()
{
    m_model = new CommissionModel(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("commissionBanner"));
    m_banner->hideMessage();
    auto* row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(buildSetup());
    row->addWidget(buildWork(), 1);
    column->addLayout(row, 1);
    new FloatingOverlay(m_banner, this, FloatingOverlay::Corner::BottomRight);
    for (QWidget* writer : {m_start, m_continue, m_same})
        new PressGuard(writer);
}

QWidget* CommissionPage::buildSetup()
{
    auto* left = new QWidget(this);
    left->setFixedWidth(setupWidth);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins({});
    m_setup = new QWidget(left);
    m_form = new QFormLayout(m_setup);
    m_form->setContentsMargins({});
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    const auto number = [this](const char* name) {
        auto* spin = new QSpinBox(m_setup);
        spin->setObjectName(QString::fromLatin1(name));
        spin->setRange(0, 253);
        return spin;
    };
    const auto row = [this](QWidget* field) { m_form->addRow(new QLabel(m_setup), field); };
    row(pathField(m_batch, m_browseBatch, "commissionBatch"));
    row(pathField(m_template, m_browseTemplate, "commissionTemplate"));
    row(m_firstId = number("commissionFirstId"));
    row(m_lastId = number("commissionLastId"));
    m_rate = new QComboBox(m_setup);
    m_rate->setObjectName(QStringLiteral("commissionRate"));
    row(m_rate);
    m_label = new QLineEdit(m_setup);
    m_label->setObjectName(QStringLiteral("commissionLabel"));
    row(m_label);
    m_center = new QCheckBox(m_setup);
    m_center->setObjectName(QStringLiteral("commissionCenter"));
    m_form->addRow(m_center);
    m_automatic = new QCheckBox(m_setup);
    m_automatic->setObjectName(QStringLiteral("commissionAutomatic"));
    m_form->addRow(m_automatic);
    m_dangerous = new QCheckBox(m_setup);
    m_dangerous->setObjectName(QStringLiteral("commissionDangerous"));
    m_dangerous->hide();
    m_form->addRow(fixedHeightRow(m_dangerous));
    m_reasonLabel = new QLabel(left);
    m_reasonLabel->setObjectName(QStringLiteral("commissionWhy"));
    m_reasonLabel->setWordWrap(true);
    m_start = button("commissionStart");
    m_start->setProperty("mainAction", true);
    m_stop = button("commissionStop");
    m_plug = button("commissionPlug");
    m_unplug = button("commissionUnplug");
    auto* run = new QHBoxLayout;
    run->addWidget(m_start, 1);
    run->addWidget(m_stop);
    auto* simButtons = new QHBoxLayout;
    simButtons->addWidget(m_plug, 1);
    simButtons->addWidget(m_unplug);
    column->addWidget(m_setup);
    // What comes and goes stands below the buttons, so that it does not move them.
    column->addLayout(run);
    column->addLayout(simButtons);
    column->addWidget(m_reasonLabel);
    column->addStretch();
    return left;
}

QWidget* CommissionPage::buildWork()
{
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins({});
    m_headline = new QLabel(right);
    m_headline->setObjectName(QStringLiteral("commissionHeadline"));
    m_headline->setWordWrap(true);
    QFont large = m_headline->font();
    large.setPointSizeF(large.pointSizeF() * headlineScale);
    large.setBold(true);
    m_headline->setFont(large);
    m_headline->setFixedHeight(headlineLines * QFontMetrics(large).lineSpacing());
    m_detail = new QLabel(right);
    m_detail->setObjectName(QStringLiteral("commissionDetail"));
    m_detail->setWordWrap(true);
    m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_saved = new QLabel(right);
    m_saved->setObjectName(QStringLiteral("commissionSaved"));
    m_saved->setWordWrap(true);
    m_saved->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_saved->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a path is one word
    m_continue = button("commissionContinue");
    m_continue->setProperty("mainAction", true);
    m_same = button("commissionSame");
    m_aside = button("commissionAside");
    auto* click = new QHBoxLayout;
    click->addWidget(m_continue);
    click->addWidget(m_aside);
    click->addWidget(m_same); // last: it is not always there
    click->addStretch();
    keepSizeWhenHidden(m_continue);
    m_table = new QTableView(right);
    m_table->setObjectName(QStringLiteral("commissionTable"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setWordWrap(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    // What is wrong with a servo stands beside its verdict, in sight at every width.
    m_table->horizontalHeader()->moveSection(CommissionModel::Remarks, 1);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_summary = new QLabel(right);
    m_summary->setObjectName(QStringLiteral("commissionSum"));
    m_summary->setWordWrap(true);
    m_copy = button("commissionCopy");
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_summary, 1);
    foot->addWidget(m_copy);
    column->addWidget(m_headline);
    column->addLayout(click);
    column->addWidget(m_detail);
    column->addWidget(m_saved);
    column->addWidget(m_table, 1);
    column->addLayout(foot);
    return right;
}

void CommissionPage::retranslate()
{
    setAccessibleName(tr("Commissioning"));
    const auto field = [this](QWidget* part, QWidget* name, const QString& words,
                              const QString& tip) {
        if (auto* label = qobject_cast<QLabel*>(m_form->labelForField(part)))
            label->setText(words);
        name->setAccessibleName(words);
        name->setToolTip(tip);
    };
    field(m_batch->parentWidget(), m_batch, tr("Batch"),
          tr("The list of the batch (CSV); one that exists is gone on with"));
    field(m_template->parentWidget(), m_template, tr("Template"),
          tr("Snapshot or template that every servo gets; empty: none"));
    field(m_firstId, m_firstId, tr("First ID"),
          tr("The ID of the first servo; the next ones count on"));
    field(m_lastId, m_lastId, tr("Last ID"), tr("The line ends when this ID has been given"));
    field(m_rate, m_rate, tr("Rate"), tr("The baud rate every servo gets"));
    field(m_label, m_label, tr("Label"),
          tr("Text of the labels: {model} {id} {rate} {baud} {firmware} {date} {was_id}"));
    m_browseBatch->setToolTip(tr("Choose the file of the batch"));
    m_browseBatch->setAccessibleName(m_browseBatch->toolTip());
    m_browseTemplate->setToolTip(tr("Choose the template"));
    m_browseTemplate->setAccessibleName(m_browseTemplate->toolTip());
    m_rate->setItemText(0, tr("as each has it"));
    m_center->setText(tr("Make the present position the middle"));
    m_center->setToolTip(
        tr("For servos with a centring command: put the horn where it belongs first"));
    m_automatic->setText(tr("Set up without asking"));
    m_automatic->setToolTip(tr("No click: what has an alarm or does not fit is set aside"));
    m_dangerous->setText(tr("Dangerous rows of the template too"));
    updateDangerousText();
    const auto words = [](QPushButton* one, const QString& text, const QString& tip) {
        one->setText(text);
        one->setAccessibleName(text);
        one->setToolTip(tip);
    };
    words(m_start, tr("Start"), tr("Wait for the first servo, or go on with the batch"));
    words(m_stop, tr("Stop"), tr("End the line; the batch can be gone on with at any time"));
    words(m_plug, tr("Plug in the next servo"),
          tr("Simulated servos: takes the next one of the bag"));
    words(m_unplug, tr("Unplug"), tr("Simulated servos: takes it off the wire"));
    words(m_same, tr("The same servo"),
          tr("It is the one that was begun; it gets the ID it was to have"));
    words(m_aside, tr("Set aside"), tr("Write nothing to this servo, and note it in the batch"));
    words(m_copy, tr("Copy labels"), tr("Labels of the selected servos, or of all, one a line"));
    for (QCheckBox* box : {m_center, m_automatic, m_dangerous})
        box->setAccessibleName(box->text());
    m_table->setAccessibleName(tr("Servos of the batch"));
    m_table->setToolTip(tr("One line a servo, as in the file of the batch"));
    m_model->retranslate();
}
} // namespace ui
