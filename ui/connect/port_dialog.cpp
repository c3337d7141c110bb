// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect/port_dialog.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

namespace ui {
PortDialog::PortDialog(QWidget* parent)
    : QDialog(parent)
    , m_label(new QLabel(this))
    , m_edit(new QLineEdit(this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this))
{
    setObjectName(QStringLiteral("portDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_edit->setObjectName(QStringLiteral("portName"));
    m_edit->setMaxLength(500);
    m_edit->setMinimumWidth(360);
    m_label->setBuddy(m_edit);
    m_label->setWordWrap(true);
    m_buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("portDialogOk"));
    makeMainAction(m_buttons->button(QDialogButtonBox::Ok));
    m_buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("portDialogCancel"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_label);
    column->addWidget(m_edit);
    column->addWidget(m_buttons);
    const auto check = [this] {
        m_buttons->button(QDialogButtonBox::Ok)->setEnabled(!portFrom(m_edit->text()).isEmpty());
    };
    connect(m_edit, &QLineEdit::textChanged, this, check);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::accepted, this,
            [this] { Q_EMIT portEntered(portFrom(m_edit->text())); });
    check();
    followLanguage(this, [this] { retranslate(); });
}

QString PortDialog::portFrom(const QString& portEntered)
{
    static const QRegularExpression hostAndPort(QStringLiteral("^[A-Za-z0-9.-]+:[0-9]{1,5}$"));
    const QString text = portEntered.trimmed();
    if (hostAndPort.match(text).hasMatch())
        return QStringLiteral("tcp://") + text;
    if (text.startsWith(QLatin1String("tty")))
        return QStringLiteral("/dev/") + text;
    return text;
}

void PortDialog::retranslate()
{
    setWindowTitle(tr("Other port"));
    m_label->setText(tr("Port path or TCP bridge address:"));
    m_edit->setPlaceholderText(tr("/dev/ttyUSB0 or tcp://192.168.1.20:4000"));
    m_edit->setToolTip(tr("For example /dev/ttyUSB0, /dev/serial/by-id/…, "
                          "tcp://192.168.1.20:4000, sim:sts3215@1,scs15@2"));
    m_edit->setAccessibleName(tr("Port or address"));
    QPushButton* ok = m_buttons->button(QDialogButtonBox::Ok);
    setButtonText(ok, tr("Choose"), tr("Selects this port; click Connect to open it"));
    QPushButton* cancel = m_buttons->button(QDialogButtonBox::Cancel);
    setButtonText(cancel, tr("Cancel"), tr("Keeps the previously selected port"));
}
} // namespace ui
