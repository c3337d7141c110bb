// SPDX-License-Identifier: GPL-3.0-or-later
// What serial port and TCP socket have in common: a Qt device used synchronously, without an event
// loop, on the thread that made it (a QThread or the main thread; Qt's socket notifiers insist).
// After the first error it is shut and every call answers LinkLost.
#pragma once

#include "transport/link.h"

#include <QIODevice>

namespace transport {
class IoLink : public Link {
public:
    base::Result<void> write(base::ByteView bytes) override;
    base::Result<std::size_t> read(base::Bytes& buffer) override;
    base::Result<bool> waitForReadyRead(base::Duration span) override;
    QString name() const override { return m_name; }

protected:
    /// The maximum that Qt buffers; further bytes wait in the system.
    static constexpr qint64 readBufferSize = 16'384;

    IoLink(QIODevice& device, QString name);
    tl::unexpected<base::Error> lostError(const QString& operation) const;
    bool isLost() const { return m_lost; }

private:
    virtual void flush() = 0;
    virtual bool hasFailed() = 0; ///< the device has failed, whether or not bytes are left to read
    virtual void closeDevice() = 0;

    bool detectLoss();
    bool waitForData(base::Duration span);

    QIODevice& m_device;
    QString m_name;
    bool m_lost = false;
};
} // namespace transport
