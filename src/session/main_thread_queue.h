// SPDX-License-Identifier: GPL-3.0-or-later
// Work handed to the main thread by others: a plain queue and one queued wake-up for all that waits
// in it. post() from any thread; everything runs on the thread of this object, in order. What
// is still in it when the object is destroyed is dropped.
#pragma once

#include <QObject>

#include <deque>
#include <functional>
#include <mutex>

namespace session {
class MainThreadQueue final : public QObject {
public:
    explicit MainThreadQueue(QObject* parent = nullptr)
        : QObject(parent)
    {}

    void post(std::function<void()> work);

protected:
    bool event(QEvent* event) override;

private:
    void drain();

    std::mutex m_mutex;
    std::deque<std::function<void()>> m_work;
};
} // namespace session
