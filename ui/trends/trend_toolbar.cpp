// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trend_toolbar.h"

#include "ui/common/theme.h"
#include "ui/widgets/flow_layout.h"

#include <QActionGroup>
#include <QComboBox>
#include <QEvent>
#include <QIcon>
#include <QLabel>
#include <QMenu>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <utility>

namespace ui {
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr std::array<Duration, 8> widths{2s, 5s, 10s, 30s, 60s, 600s, 3600s, 14400s};
constexpr int buttonSpacing = 4;
constexpr std::array rates{0, 200, 100, 50, 20, 10, 5, 1};
constexpr std::array memories{64, 128, 256, 512, 1024}; ///< MB
const QStringList liveOnly{QStringLiteral("trendClear"), QStringLiteral("trendTriggerMenu")};

void setTexts(QToolButton* button, const QString& text, const QString& tip)
{
    button->setText(text);
    button->setToolTip(text + QStringLiteral(": ") + tip);
    button->setAccessibleName(text);
    button->setAccessibleDescription(tip);
}
} // namespace

TrendToolbar::TrendToolbar(QWidget* parent)
    : QWidget(parent)
    , m_layout(new FlowLayout(this, buttonSpacing))
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    m_live = addButton("trendLive", "media-playback-start");
    m_pause = addButton("trendPause", "media-playback-pause", true);
    m_width = new QComboBox(this);
    m_width->setObjectName(QStringLiteral("trendWidth"));
    m_layout->addWidget(m_width);
    m_fit = addButton("trendFit", "zoom-fit-best");
    m_lanes = addButton("trendLanes", "view-split-top-bottom", true);
    m_cursors = addButton("trendCursors", "measure", true);
    m_record = addButton("trendRecord", "media-record");
    m_recordState = new QLabel(this);
    m_recordState->setObjectName(QStringLiteral("trendRecordState"));
    m_layout->addWidget(m_recordState);
    m_channels = addButton("trendChannels", "office-chart-line");
    m_trigger = addButton("trendTrigger", "flag");
    m_more = addButton("trendMore", "application-menu");
    m_menu = new QMenu(this);
    m_menu->setObjectName(QStringLiteral("trendMenu"));
    // Not the button's own menu: it runs an event loop of its own.
    connect(m_more, &QToolButton::clicked, this,
            [this] { showMenu(m_more->mapToGlobal(QPoint(0, m_more->height()))); });
    // Space is scarce: these have an icon, a tooltip and a name, but no text.
    for (QToolButton* button : {m_pause, m_fit, m_lanes, m_cursors, m_more})
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    connectControls();
    retranslate();
    setReplaying(false);
    setRecording({});
}

void TrendToolbar::connectControls()
{
    connect(m_pause, &QToolButton::clicked, this, [this](bool on) { Q_EMIT followRequested(!on); });
    connect(m_width, &QComboBox::activated, this, [this](int index) {
        Q_EMIT widthRequested(widths.at(static_cast<std::size_t>(index)));
    });
    connect(m_fit, &QToolButton::clicked, this, &TrendToolbar::fitRequested);
    connect(m_cursors, &QToolButton::clicked, this, &TrendToolbar::cursorsRequested);
    connect(m_lanes, &QToolButton::clicked, this, &TrendToolbar::lanesRequested);
    connect(m_channels, &QToolButton::clicked, this, &TrendToolbar::channelsRequested);
    connect(m_trigger, &QToolButton::clicked, this, &TrendToolbar::triggerRequested);
    connect(m_live, &QToolButton::clicked, this, &TrendToolbar::liveRequested);
    connect(m_record, &QToolButton::clicked, this, &TrendToolbar::recordRequested);
}

QToolButton* TrendToolbar::addButton(const char* name, const char* icon, bool checkable)
{
    auto* button = new QToolButton(this);
    button->setObjectName(QString::fromLatin1(name));
    button->setProperty("iconName", QString::fromLatin1(icon));
    button->setIcon(QIcon::fromTheme(QString::fromLatin1(icon)));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(checkable);
    m_layout->addWidget(button);
    return button;
}

void TrendToolbar::showMenu(const QPoint& place)
{
    m_menu->popup(place);
}

/// Where one row has no room for them, buttons show their icons only, and what the menu and a
/// double click have as well is hidden.
void TrendToolbar::fitTexts()
{
    if (std::exchange(m_isFitting, true))
        return; // a change of style may lay out at once
    const auto setStyle = [this](Qt::ToolButtonStyle style) {
        for (QToolButton* button : {m_live, m_record, m_channels, m_trigger})
            button->setToolButtonStyle(style);
    };
    setStyle(Qt::ToolButtonTextBesideIcon);
    int needed = -buttonSpacing;
    for (int i = 0; i < m_layout->count(); ++i) {
        const QWidget* const widget = m_layout->itemAt(i)->widget();
        if (!widget->isHidden() || widget == m_fit)
            needed += widget->sizeHint().width() + buttonSpacing;
    }
    const bool fits = needed <= width();
    if (!fits)
        setStyle(Qt::ToolButtonIconOnly);
    m_fit->setVisible(fits);
    m_isFitting = false;
}

void TrendToolbar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fitTexts();
}

void TrendToolbar::setFollowing(bool following)
{
    m_pause->setChecked(!following);
}

void TrendToolbar::setShownWidth(Duration width)
{
    const auto place = std::find(widths.begin(), widths.end(), width);
    const QSignalBlocker blocker(m_width);
    m_width->setCurrentIndex(place != widths.end() ? int(place - widths.begin()) : -1);
}

void TrendToolbar::setCursorsShown(bool shown)
{
    m_cursors->setChecked(shown);
}

void TrendToolbar::setLanes(bool on)
{
    m_lanes->setChecked(on);
}

void TrendToolbar::setTrigger(const QString& words, bool waiting)
{
    m_triggerWords = words;
    setTexts(m_trigger, words.isEmpty() ? tr("Trigger") : words,
             waiting ? tr("Stops waiting for the event")
                     : tr("Pauses the chart when an event occurs"));
    m_trigger->setVisible(!words.isEmpty()); // else it is in the menu
    m_trigger->setProperty("waiting", waiting);
    fitTexts();
    fillMenu();
}

void TrendToolbar::setRecording(const QString& words)
{
    const bool needsRoom = words.size() != m_recordWords.size();
    m_recordWords = words;
    const bool runs = !words.isEmpty();
    if (runs)
        setTexts(m_record, tr("Stop recording"), tr("Ends the recording and closes its file"));
    else
        setTexts(m_record, tr("Record…"), tr("Records measured values to a file"));
    const QString icon =
        runs ? QStringLiteral("media-playback-stop") : QStringLiteral("media-record");
    if (m_record->property("iconName") != icon) {
        m_record->setProperty("iconName", icon);
        m_record->setIcon(QIcon::fromTheme(icon));
    }
    m_recordState->setText(runs ? QStringLiteral("● ") + words : QString());
    m_recordState->setVisible(runs);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(Tone::Bad, palette()));
    m_recordState->setPalette(colors);
    if (needsRoom)
        fitTexts();
}

void TrendToolbar::setRate(int hz)
{
    m_rate = hz;
    fillMenu();
}

void TrendToolbar::setMemory(int megabytes)
{
    m_memory = megabytes;
    fillMenu();
}

void TrendToolbar::setReplaying(bool replaying)
{
    m_replaying = replaying;
    m_live->setVisible(replaying);
    fitTexts();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_pause, m_trigger, m_channels})
        widget->setEnabled(!replaying);
    fillMenu();
}

void TrendToolbar::setPresets(const QStringList& names)
{
    m_presets = names;
    fillMenu();
}

void TrendToolbar::fillMenu()
{
    for (QMenu* old : m_menu->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly))
        old->deleteLater(); // one of their actions may be running
    m_menu->clear();
    m_menu->setToolTipsVisible(true);
    const auto action = [this](const char* name, const QString& text, auto signal) {
        QAction* one = m_menu->addAction(text);
        one->setObjectName(QString::fromLatin1(name));
        one->setEnabled(!m_replaying || !liveOnly.contains(QLatin1String(name)));
        connect(one, &QAction::triggered, this, signal);
    };
    action("trendShowAll", tr("Show &all"), &TrendToolbar::fitRequested);
    action("trendBack", tr("&Previous view"), &TrendToolbar::backRequested);
    action("trendTriggerMenu", m_triggerWords.isEmpty() ? tr("&Trigger…") : m_triggerWords,
           &TrendToolbar::triggerRequested);
    addRates();
    addMemories();
    m_menu->addSeparator();
    action("trendExport", tr("&Export view…"), &TrendToolbar::exportRequested);
    action("trendOpen", tr("&Open a recording…"), &TrendToolbar::openRequested);
    action("trendClear", tr("&Clear chart data"), &TrendToolbar::clearRequested);
    m_menu->addSeparator();
    action("trendPresetSave", tr("Save &view as…"), &TrendToolbar::presetSaveRequested);
    addPresets();
}

void TrendToolbar::addRates()
{
    QMenu* menu = m_menu->addMenu(tr("&Readings per second"));
    menu->setObjectName(QStringLiteral("trendRates"));
    menu->setEnabled(!m_replaying);
    for (const int hz : rates)
        addChoice(menu, hz == 0 ? tr("As fast as the bus allows") : tr("%1 Hz").arg(hz),
                  hz == m_rate, [this, hz] {
                      m_rate = hz;
                      Q_EMIT rateRequested(hz);
                  });
}

/// What is older than this holds keeps only its extremes, and then goes.
void TrendToolbar::addMemories()
{
    QMenu* menu = m_menu->addMenu(tr("&Memory for readings"));
    menu->setObjectName(QStringLiteral("trendMemories"));
    menu->setEnabled(!m_replaying);
    for (const int megabytes : memories)
        addChoice(menu, tr("%1 MB").arg(megabytes), megabytes == m_memory, [this, megabytes] {
            m_memory = megabytes;
            Q_EMIT memoryRequested(megabytes);
        });
}

void TrendToolbar::addChoice(QMenu* menu, const QString& text, bool isChosen,
                             const std::function<void()>& choose)
{
    auto* group = menu->findChild<QActionGroup*>();
    if (group == nullptr)
        group = new QActionGroup(menu);
    QAction* one = menu->addAction(text);
    one->setCheckable(true);
    one->setChecked(isChosen);
    group->addAction(one);
    connect(one, &QAction::triggered, this, choose);
}

void TrendToolbar::addPresets()
{
    for (const QString& name : m_presets)
        connect(m_menu->addAction(name), &QAction::triggered, this,
                [this, name] { Q_EMIT presetRequested(name); });
    if (m_presets.isEmpty())
        return;
    QMenu* remove = m_menu->addMenu(tr("&Delete view"));
    for (const QString& name : m_presets)
        connect(remove->addAction(name), &QAction::triggered, this,
                [this, name] { Q_EMIT presetRemoveRequested(name); });
}

void TrendToolbar::retranslate()
{
    setTexts(m_pause, tr("Pause"), tr("Pauses the chart; measuring continues (Space)"));
    setTexts(m_fit, tr("All"), tr("Shows all measured data"));
    setTexts(m_lanes, tr("Lanes"), tr("Shows each quantity in its own lane"));
    setTexts(m_cursors, tr("Cursors"), tr("Measures between two cursors"));
    setTexts(m_channels, tr("Channels…"), tr("Selects the servos and registers to show"));
    setTexts(m_more, tr("More"), tr("Trigger, read rate, export, recordings and saved views"));
    setTexts(m_live, tr("Back to live data"), tr("Closes the recording and shows live values"));
    m_recordState->setAccessibleName(tr("Recording"));
    m_width->setAccessibleName(tr("Time shown"));
    m_width->setToolTip(tr("Length of time shown in the chart"));
    retranslateWidths();
    fillMenu();
    setRecording(m_recordWords);
    setTrigger(m_triggerWords, m_trigger->property("waiting").toBool()); // fits all texts
}

void TrendToolbar::retranslateWidths()
{
    const QSignalBlocker widthBlocker(m_width);
    const int width = m_width->count() > 0 ? m_width->currentIndex() : 2;
    m_width->clear();
    for (const Duration one : widths) {
        const auto seconds = one.count() / 1'000'000;
        if (seconds < 60)
            m_width->addItem(tr("%1 s").arg(seconds));
        else if (seconds < 3600)
            m_width->addItem(tr("%1 min").arg(seconds / 60));
        else
            m_width->addItem(tr("%1 h").arg(seconds / 3600));
    }
    m_width->setCurrentIndex(width);
}

void TrendToolbar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange) {
        for (QToolButton* button : findChildren<QToolButton*>())
            button->setIcon(QIcon::fromTheme(button->property("iconName").toString()));
        setRecording(m_recordWords);
    }
}
} // namespace ui
