// SPDX-License-Identifier: GPL-3.0-or-later
// While it lives, this process cannot make a file larger than `bytes`: writes stop half-way with an
// error, as on a full disk. Unix only.
#pragma once

#include <QtTest>

#include <csignal>
#include <sys/resource.h>

class FileSizeLimit {
public:
    explicit FileSizeLimit(qint64 bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        QVERIFY2(::getrlimit(RLIMIT_FSIZE, &m_before) == 0, "getrlimit");
        rlimit limited = m_before;
        limited.rlim_cur = rlim_t(bytes);
        QVERIFY2(::setrlimit(RLIMIT_FSIZE, &limited) == 0, "setrlimit");
    }
    ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &m_before); }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit m_before = {};
};
