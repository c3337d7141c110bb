// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect/port_picker.h"

#include "session/session.h"
#include "text/bus_text.h"
#include "ui/common/follow_language.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStylePainter>
#include <QWheelEvent>

#include <algorithm>

namespace ui {
namespace {
const QString otherKey = QStringLiteral("*");
constexpr int keyRole = Qt::UserRole;
constexpr int shortTextRole = Qt::UserRole + 1;
constexpr int minChars = 22; ///< characters

bool isDevice(const QString& port)
{
    return !port.startsWith(QLatin1String("sim:")) && !port.startsWith(QLatin1String("tcp:"));
}

QString shortName(const QString& path)
{
    return path.startsWith(QLatin1String("/dev/")) ? path.mid(5) : path;
}
} // namespace

PortPicker::PortPicker(session::PortWatcher& ports, QWidget* parent)
    : QComboBox(parent)
    , m_ports(ports)
{
    setObjectName(QStringLiteral("portPicker"));
    setModel(new QStandardItemModel(this));
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(minChars);
    setMaxVisibleItems(20);
    connect(&m_ports, &session::PortWatcher::portsChanged, this, [this] {
        updatePath();
        refresh();
    });
    connect(this, &QComboBox::activated, this, &PortPicker::activatedAt);
    followLanguage(this, [this] { refresh(); });
}

void PortPicker::setPort(const QString& port)
{
    setCurrent(port);
    m_selectedByUser = true;
    refresh();
}

void PortPicker::suggest(const QString& port)
{
    if (m_selectedByUser)
        return;
    setCurrent(port);
    refresh();
}

void PortPicker::setCurrent(const QString& port)
{
    m_port = port;
    m_key = m_ports.adapterKey(port);
    const session::PortInfo* info = m_ports.find(port);
    m_shownAs = info != nullptr ? entryFor(*info).text : shortName(port);
    if (info == nullptr && !port.isEmpty() && !session::simulatedPorts().contains(port) &&
        !m_typed.contains(port))
        m_typed << port;
}

bool PortPicker::isMissing() const
{
    return m_ports.isReady() && isDevice(m_port) && !m_port.isEmpty() &&
           m_key != m_port && // it was seen as an adapter
           m_ports.find(m_port) == nullptr;
}

/// The user has chosen the adapter; its path may change.
void PortPicker::updatePath()
{
    if (m_port.isEmpty() || !isDevice(m_port))
        return;
    if (m_key == m_port) // named before anybody knew what it is
        m_key = m_ports.adapterKey(m_port);
    if (m_ports.find(m_port) != nullptr && m_ports.adapterKey(m_port) == m_key) {
        m_shownAs = entryFor(*m_ports.find(m_port)).text;
        return;
    }
    const QString now = m_ports.findAdapter(m_key);
    // Without a serial number it may be another adapter of this type, so the user must choose.
    if (now.isEmpty() || now == m_port || !m_key.contains(QLatin1Char('#')))
        return;
    m_port = now;
    m_shownAs = entryFor(*m_ports.find(now)).text;
    Q_EMIT portSelected(m_port);
}

PortPicker::Entry PortPicker::entryFor(const session::PortInfo& info) const
{
    const QString name = shortName(info.path);
    QStringList known;
    QStringList tip{info.path};
    const auto add = [&](const QString& part, const QString& line) {
        if (!part.isEmpty() && !known.contains(part))
            known << part;
        if (!part.isEmpty())
            tip << line.arg(part);
    };
    add(info.description, tr("Description: %1"));
    add(info.manufacturer, tr("Vendor: %1"));
    add(info.serialNumber, tr("Serial number: %1"));
    if (info.vendorId != 0)
        tip << tr("USB %1:%2")
                   .arg(info.vendorId, 4, 16, QLatin1Char('0'))
                   .arg(info.productId, 4, 16, QLatin1Char('0'));
    const QString text =
        known.isEmpty() ? name : name + QStringLiteral(" — ") + known.join(QStringLiteral(" · "));
    return {info.path, text, tip.join(QLatin1Char('\n'))};
}

std::vector<PortPicker::Entry> PortPicker::entries() const
{
    std::vector<Entry> entries;
    int lines = 0;
    const auto line = [&] {
        if (!entries.empty() && !entries.back().separator)
            entries.push_back({QStringLiteral("-%1").arg(++lines), {}, {}, true});
    };
    for (const session::PortInfo& info : m_ports.ports())
        entries.push_back(entryFor(info));
    const bool gone = isMissing();
    if (gone)
        entries.push_back({m_port, tr("%1 (not plugged in)").arg(m_shownAs),
                           tr("%1 is not plugged in; it stays selected").arg(m_port)});
    line();
    for (const QString& typed : m_typed) {
        const bool listed = m_ports.find(typed) != nullptr || (gone && typed == m_port);
        if (!listed)
            entries.push_back({typed, shortName(typed), typed});
    }
    line();
    for (const QString& name : session::simulatedPorts())
        entries.push_back({name, tr("Simulated bus: %1").arg(name.section(QLatin1Char(':'), 1)),
                           tr("Simulated servos, no hardware needed"), false,
                           text::simulatedBusText(name)});
    line();
    entries.push_back({otherKey, tr("Other port or TCP address…"),
                       tr("Enter a path such as /dev/ttyUSB0 or an address such as "
                          "tcp://192.168.1.20:4000")});
    return entries;
}

void PortPicker::refresh()
{
    const QSignalBlocker quiet(this);
    setPlaceholderText(tr("Select a port"));
    sync(entries());
    setCurrentIndex(m_port.isEmpty() ? -1 : findData(m_port, keyRole));
    setAccessibleName(tr("Port"));
    showTip();
}

/// Entries that stay are not touched, so that an open list does not jump under the pointer.
void PortPicker::sync(const std::vector<Entry>& entries)
{
    auto* items = static_cast<QStandardItemModel*>(model());
    const auto hasEntry = [&](const QString& key) {
        return std::any_of(entries.begin(), entries.end(),
                           [&](const Entry& entry) { return entry.key == key; });
    };
    for (int row = items->rowCount() - 1; row >= 0; --row) {
        if (!hasEntry(items->item(row)->data(keyRole).toString()))
            items->removeRow(row);
    }
    for (int row = 0; row < int(entries.size()); ++row) {
        const Entry& entry = entries[std::size_t(row)];
        QStandardItem* item = items->item(row);
        if (item == nullptr || item->data(keyRole).toString() != entry.key) {
            const int old = findData(entry.key, keyRole);
            item = old > row ? items->takeRow(old).front() : new QStandardItem;
            items->insertRow(row, item);
        }
        item->setData(entry.key, keyRole);
        item->setText(entry.about.isEmpty() ? entry.text
                                            : entry.text + QStringLiteral(" — ") + entry.about);
        item->setData(entry.text, shortTextRole);
        item->setToolTip(entry.tip);
        if (entry.separator) {
            item->setData(QStringLiteral("separator"), Qt::AccessibleDescriptionRole);
            item->setFlags(Qt::NoItemFlags);
        }
    }
}

/// The open list describes the simulated buses; the closed one has no room for that.
void PortPicker::paintEvent(QPaintEvent* event)
{
    if (currentIndex() < 0)
        return QComboBox::paintEvent(event);
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    option.currentText = itemData(currentIndex(), shortTextRole).toString();
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

/// As wide as its entries, so that none is cut.
void PortPicker::showPopup()
{
    view()->setMinimumWidth(view()->sizeHintForColumn(0) +
                            style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    QComboBox::showPopup();
}

void PortPicker::activatedAt(int index)
{
    const QString key = itemData(index, keyRole).toString();
    if (key == otherKey) {
        refresh(); // back to what was chosen, until a name has been typed
        Q_EMIT otherPortRequested();
        return;
    }
    setPort(key);
    Q_EMIT portSelected(key);
}

void PortPicker::showTip()
{
    const QString about =
        currentIndex() < 0 ? QString() : itemData(currentIndex(), Qt::ToolTipRole).toString();
    const QString tip = tr("Port to which the servos are connected");
    setToolTip(about.isEmpty()
                   ? tip
                   : tip + QLatin1Char('\n') + currentText() + QLatin1Char('\n') + about);
}

/// The last entry is no port: keys that walk through the ports stop before it.
void PortPicker::keyPressEvent(QKeyEvent* event)
{
    const bool walksOn = event->key() == Qt::Key_Down && event->modifiers() == Qt::NoModifier;
    if ((walksOn && currentIndex() >= 0 &&
         itemData(currentIndex() + 2, keyRole).toString() == otherKey) ||
        event->key() == Qt::Key_End) {
        event->accept();
        return;
    }
    QComboBox::keyPressEvent(event);
}

/// Scrolling past it must not choose another port.
void PortPicker::wheelEvent(QWheelEvent* event)
{
    event->ignore();
}
} // namespace ui
