// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect/connect_bar.h"

#include "session/connection.h"
#include "text/bus_text.h"
#include "ui/connect/link_options.h"
#include "ui/connect/port_dialog.h"
#include "ui/connect/port_picker.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/rate_text.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

namespace ui {
using session::LinkState;
using namespace std::chrono_literals;

ConnectBar::ConnectBar(session::Workbench& workbench, Commands& commands,
                       session::Settings& settings, session::PortWatcher& ports, QWidget* parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_commands(commands)
    , m_settings(settings)
    , m_ports(ports)
    , m_port(new PortPicker(ports, this))
    , m_baud(new QComboBox(this))
    , m_protocol(new QComboBox(this))
    , m_more(new QToolButton(this))
    , m_options(new LinkOptions(this))
    , m_button(new QToolButton(this))
    , m_status(new Pill(this))
    , m_simulated(new Pill(this, true))
{
    build();
    connectSignals();
    suggestPort();
    retranslate();
    linkChanged();
}

void ConnectBar::build()
{
    setObjectName(QStringLiteral("connectBar"));
    m_baud->setObjectName(QStringLiteral("baudBox"));
    m_protocol->setObjectName(QStringLiteral("protocolBox"));
    m_more->setObjectName(QStringLiteral("moreButton"));
    m_button->setObjectName(QStringLiteral("connectButton"));
    m_status->setObjectName(QStringLiteral("linkStatus"));
    m_simulated->setObjectName(QStringLiteral("simulatedBadge"));
    m_more->setIcon(QIcon::fromTheme(QStringLiteral("configure")));
    m_button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_button->setFocusPolicy(Qt::StrongFocus);
    m_more->setFocusPolicy(Qt::StrongFocus);
    m_baud->addItem(QString());
    for (const int rate : session::standardBaudRates())
        m_baud->addItem(rateText(rate), rate);
    m_baud->setMaxVisibleItems(20);
    m_protocol->addItem(QString());
    for (const base::Protocol protocol : base::allProtocols)
        m_protocol->addItem(QString(), base::protocolName(protocol));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_port);
    for (QWidget* field : std::initializer_list<QWidget*>{m_baud, m_protocol, m_more, m_button})
        row->addWidget(field);
    row->addWidget(m_status);
    row->addStretch(1);
    row->addWidget(m_simulated);
}

void ConnectBar::connectSignals()
{
    connect(m_port, &PortPicker::portSelected, this, &ConnectBar::portChosen);
    connect(m_port, &PortPicker::otherPortRequested, this, &ConnectBar::askForPort);
    connect(&m_ports, &session::PortWatcher::portsChanged, this, &ConnectBar::suggestPort);
    connect(m_more, &QToolButton::clicked, this, [this] { m_options->popUpBelow(*m_more); });
    connect(m_options, &LinkOptions::changed, this, [this] { retranslate(); });
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this,
            &ConnectBar::linkChanged);
    // Errors before a search count as usual, those during it do not.
    connect(&m_workbench.search(), &session::SearchService::searchChanged, this, [this] {
        if (m_state == LinkState::Open)
            m_meter.addStatistics(m_workbench.link().statistics(),
                                  !m_workbench.search().isSearching(), m_workbench.now());
    });
    // Nor do the answers to a stop, for which the program does not wait.
    connect(&m_workbench, &session::Workbench::eventOccurred, this,
            [this](const session::Event& event) {
                if (event.kind != session::Event::Kind::Stopped || m_state != LinkState::Open)
                    return;
                m_meter.addStatistics(m_workbench.link().statistics(),
                                      m_workbench.search().isSearching(), m_workbench.now());
                m_stopped = true;
            });
    connect(m_commands.action(Command::Connect), &QAction::triggered, this,
            &ConnectBar::connectNow);
    const auto useOnCommand = [this](Command command, const QString& port) {
        connect(m_commands.action(command), &QAction::triggered, this, [this, port] {
            setRequest({.name = port});
            connectNow();
        });
    };
    useOnCommand(Command::UseSimulation, session::simulatedPorts().constFirst());
    useOnCommand(Command::UseSimulatedArm, QStringLiteral("sim:so101"));
    m_timer.setInterval(1s);
    connect(&m_timer, &QTimer::timeout, this, &ConnectBar::updateState);
}

/// Until the user has chosen: the adapter used last under its present name, else the port used last
/// if it is no adapter, else the first adapter.
void ConnectBar::suggestPort()
{
    if (m_port->isSelectedByUser() || m_workbench.link().state() != LinkState::Off)
        return;
    const QString last = m_settings.lastPort();
    const QString present = m_ports.findAdapter(m_settings.lastAdapter());
    QString port = present.isEmpty() ? last : present;
    const bool device =
        !last.startsWith(QLatin1String("sim:")) && !last.startsWith(QLatin1String("tcp:"));
    const auto& ports = m_ports.ports();
    if (present.isEmpty() && device && !ports.empty() && ports.front().vendorId != 0)
        port = ports.front().path;
    if (port == m_port->port())
        return;
    m_port->suggest(port);
    if (!port.isEmpty())
        portChosen(port);
}

void ConnectBar::portChosen(const QString& port)
{
    if (m_workbench.link().state() != LinkState::Off &&
        m_workbench.link().state() != LinkState::Lost)
        return;
    session::PortRequest used = m_settings.lastRequestFor(m_ports.adapterKey(port));
    const QSignalBlocker quiet(m_options);
    m_baud->setCurrentIndex(qMax(0, m_baud->findData(used.baud.value_or(0))));
    m_protocol->setCurrentIndex(
        used.protocol ? m_protocol->findData(base::protocolName(*used.protocol)) : 0);
    m_options->show(used);
    retranslate();
}

void ConnectBar::askForPort()
{
    auto* dialog = new PortDialog(this);
    connect(dialog, &PortDialog::portEntered, this, [this](const QString& port) {
        m_port->setPort(port);
        portChosen(port);
    });
    dialog->open();
}

session::PortRequest ConnectBar::request() const
{
    session::PortRequest request;
    m_options->apply(request);
    request.name = m_port->port();
    if (const int baud = m_baud->currentData().toInt(); baud > 0)
        request.baud = baud;
    request.protocol = base::protocolFromName(m_protocol->currentData().toString());
    return request;
}

void ConnectBar::setRequest(const session::PortRequest& request)
{
    m_port->setPort(request.name);
    const int baud = request.baud.value_or(0);
    if (baud > 0 && m_baud->findData(baud) < 0) // a rate of the user's own
        m_baud->addItem(rateText(baud), baud);
    m_baud->setCurrentIndex(qMax(0, m_baud->findData(baud)));
    m_protocol->setCurrentIndex(
        request.protocol ? m_protocol->findData(base::protocolName(*request.protocol)) : 0);
    m_options->show(request);
    retranslate();
}

void ConnectBar::connectNow()
{
    if (m_port->port().isEmpty())
        m_port->showPopup();
    else
        m_workbench.link().connectTo(request());
}

void ConnectBar::linkChanged()
{
    const LinkState state = m_workbench.link().state();
    if (state == LinkState::Open && m_state != LinkState::Open) {
        m_meter.reset();
        saveRequest();
    }
    m_state = state;
    const bool mayChange = state == LinkState::Off || state == LinkState::Lost;
    for (QWidget* field : std::initializer_list<QWidget*>{m_port, m_baud, m_protocol, m_more})
        field->setEnabled(mayChange);
    m_simulated->setVisible(m_workbench.link().isSimulated());
    if (state == LinkState::Open)
        m_timer.start();
    else
        m_timer.stop();
    showButton();
    updateState();
}

void ConnectBar::saveRequest()
{
    const session::PortRequest& used = m_workbench.link().lastRequest();
    m_settings.saveRequest(m_ports.adapterKey(used.name), used);
}

/// One button for both: pressing it does what its text names, and it never moves.
void ConnectBar::showButton()
{
    const bool connects = m_state == LinkState::Off || m_state == LinkState::Lost;
    QAction* buttonAction = m_commands.action(connects ? Command::Connect : Command::Disconnect);
    if (m_button->defaultAction() != buttonAction) {
        if (QAction* old = m_button->defaultAction())
            m_button->removeAction(old);
        m_button->setDefaultAction(buttonAction);
        m_button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    }
    m_button->setAccessibleName(buttonAction->iconText());
    const QFontMetrics metrics = m_button->fontMetrics();
    const int frame = m_button->sizeHint().width() - metrics.horizontalAdvance(m_button->text());
    int width = 0;
    for (const Command command : {Command::Connect, Command::Disconnect})
        width = qMax(width, metrics.horizontalAdvance(m_commands.action(command)->iconText()));
    m_button->setMinimumWidth(width + frame);
}

void ConnectBar::updateState()
{
    if (m_state == LinkState::Open)
        m_meter.addStatistics(m_workbench.link().statistics(),
                              m_workbench.search().isSearching() || m_stopped, m_workbench.now());
    m_stopped = false;
    showStatistics();
}

void ConnectBar::showStatistics()
{
    switch (m_state) {
    case LinkState::Off:
        return m_status->setState(Tone::Quiet, tr("not connected"));
    case LinkState::Opening:
        return m_status->setState(Tone::Accent, tr("opening the port…"));
    case LinkState::Closing:
        return m_status->setState(Tone::Accent, tr("closing the port…"));
    case LinkState::Lost:
        return m_status->setState(Tone::Bad, tr("disconnected"));
    case LinkState::Open:
        break;
    }
    session::Connection* connection = m_workbench.link().connection();
    if (connection != nullptr && connection->bus().isReconnecting()) {
        return m_status->setState(Tone::Warn, tr("adapter disconnected, waiting up to 5 s"),
                                  tr("waiting…"),
                                  tr("The adapter was unplugged or lost power. A running test will "
                                     "continue when the adapter is back, but torque will not be "
                                     "turned back on for servos that rebooted in the meantime."));
    }
    const LinkMeter::Values& now = m_meter.values();
    const bus::Statistics sum = m_workbench.link().statistics();
    const auto figure = [this](auto value) { return locale().toString(qulonglong(value)); };
    const QString words = (now.errors == 1 ? tr("%1 reads/s · %2 error · bus load %3 %")
                                           : tr("%1 reads/s · %2 errors · bus load %3 %"))
                              .arg(figure(now.readsPerSecond), figure(now.errors))
                              .arg(qRound(now.busLoad * 100));
    const QString brief = tr("%1/s · %2 err").arg(figure(now.readsPerSecond), figure(now.errors));
    const QString more =
        tr("Port: %1 at %2 baud\nSent: %3, replies: %4\nLost: %5, damaged: %6, unexpected: %7, "
           "late: %8\nRetries: %9")
            .arg(m_workbench.link().lastRequest().name,
                 m_workbench.link().canSetBaud() ? rateText(m_workbench.link().baud())
                                                 : QStringLiteral("–"),
                 figure(sum.total.sent), figure(sum.total.ok), figure(sum.total.timeouts),
                 figure(sum.total.badChecksums), figure(sum.total.foreign), figure(sum.total.late),
                 figure(sum.total.retried)) +
        QLatin1Char('\n') +
        tr("Round trip: median %1 ms, 99th percentile %2 ms")
            .arg(double(sum.total.roundTripP50.count()) / 1000, 0, 'f', 2)
            .arg(double(sum.total.roundTripP99.count()) / 1000, 0, 'f', 2);
    m_status->setState(now.errors == 0 ? Tone::Good : Tone::Warn, words, brief, more);
}

void ConnectBar::retranslate()
{
    m_baud->setItemText(0, tr("Baud: auto"));
    m_baud->setAccessibleName(tr("Baud rate"));
    m_baud->setToolTip(tr("Baud rate of the port (auto: the factory baud rate of servos that use "
                          "the selected protocol)"));
    m_protocol->setItemText(0, tr("Protocol: auto"));
    for (std::size_t i = 0; i < base::allProtocols.size(); ++i)
        m_protocol->setItemText(int(i) + 1, text::protocolText(base::allProtocols[i]));
    m_protocol->setAccessibleName(tr("Protocol"));
    m_protocol->setToolTip(tr("Protocol of the servos (auto: tries all protocols that are possible "
                              "at the selected baud rate)"));
    const QString set = m_options->isDefault() ? QString() : tr(" (changed)");
    m_more->setText(m_options->isDefault() ? QStringLiteral("…") : QStringLiteral("…*"));
    m_more->setToolButtonStyle(m_options->isDefault() ? Qt::ToolButtonIconOnly
                                                      : Qt::ToolButtonTextBesideIcon);
    m_more->setAccessibleName(tr("More port settings"));
    m_more->setToolTip(tr("Parity, timeout, Modbus frame gap, retries") + set);
    m_simulated->setState(Tone::Warn, tr("SIMULATED"), {},
                          tr("These servos are simulated on this computer"));
    showButton();
    showStatistics();
}

void ConnectBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::FontChange)
        showButton();
}
} // namespace ui
