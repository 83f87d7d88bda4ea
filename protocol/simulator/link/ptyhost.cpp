// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/ptyhost.h"

#include <QFile>
#include <QFileInfo>

#include <asm/termbits.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <tuple>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kReadBuffer = 4096;
constexpr qsizetype kPtyBacklog = 4096;  // in addition to what the system buffers for a slow reader

}  // namespace

PtyHost::PtyHost(std::unique_ptr<SimulatedPort> port, QString path, QObject *parent)
    : SimulatorHost(std::move(port), parent)
    , m_path(std::move(path))
{
}

PtyHost::~PtyHost()
{
    closeTerminal();
}

Result<void> PtyHost::start()
{
    const QFileInfo info(m_path);
    // A link left behind by a simulator that was killed may be removed; anything else at that path is not
    // ours.
    if (info.isSymLink() && !info.exists())
        QFile::remove(m_path);
    else if (info.exists() || info.isSymLink())
        return failure(ErrorCode::PortBusy, u"%1 exists already"_s.arg(m_path));
    if (auto opened = openTerminal(); !opened)
        return opened;
    return SimulatorHost::start();
}

Result<void> PtyHost::openTerminal()
{
    m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0)
        return failure(ErrorCode::PortNotFound,
                       u"no pseudo-terminal: %1"_s.arg(QString::fromLocal8Bit(std::strerror(errno))));
    m_slave = QString::fromLocal8Bit(::ptsname(m_master));
    // Raw from the start: a client that only reads and writes must not get its bytes echoed.
    struct termios2 settings
    {
    };
    if (::ioctl(m_master, TCGETS2, &settings) == 0) {
        settings.c_iflag = 0;
        settings.c_oflag = 0;
        settings.c_lflag = 0;
        settings.c_cflag
            = (settings.c_cflag & ~static_cast<tcflag_t>(CSIZE | CBAUD)) | CS8 | CREAD | CLOCAL | B115200;
        ::ioctl(m_master, TCSETS2, &settings);
    }
    if (!QFile::link(m_slave, m_path)) {
        closeTerminal();
        return failure(ErrorCode::NoPermission, u"%1 cannot be made"_s.arg(m_path));
    }
    return {};
}

void PtyHost::closeTerminal()
{
    if (m_master < 0)
        return;
    if (QFileInfo(m_path).symLinkTarget() == m_slave)
        QFile::remove(m_path);
    ::close(m_master);
    m_master = -1;
    m_unsent.clear();
}

void PtyHost::poll()
{
    if (m_master < 0)
        return;
    drain();
    // The host's rate can be read from the terminal; its parity cannot, because Linux does not keep it on
    // pseudo-terminals.
    struct termios2 settings
    {
    };
    if (::ioctl(m_master, TCGETS2, &settings) == 0)
        port().setHostLine(
            LineSettings{int(settings.c_ospeed), port().board().onlyParity().value_or(Parity::None)});
    char buffer[kReadBuffer];
    for (;;) {
        const ssize_t count = ::read(m_master, buffer, sizeof buffer);
        if (count <= 0)
            break;  // nothing to read, or nobody has opened the other end
        hostWrote(QByteArrayView(buffer, count));
    }
}

void PtyHost::deliver(const QByteArray &bytes)
{
    if (m_master < 0)
        return;
    m_unsent += bytes;
    drain();
}

void PtyHost::drain()
{
    const ssize_t count
        = m_unsent.isEmpty() ? 0 : ::write(m_master, m_unsent.constData(), std::size_t(m_unsent.size()));
    if (count > 0)
        m_unsent.remove(0, count);
    // Nobody reads: on USB the board has to wait, which makes it skip streams; a UART does not wait, and its
    // bytes are lost.
    port().setHostReady(m_unsent.size() < kPtyBacklog);
    if (m_unsent.size() > 2 * kPtyBacklog)
        m_unsent.truncate(kPtyBacklog);
}

void PtyHost::plugged(bool in)
{
    if (in)
        std::ignore = openTerminal();
    else
        closeTerminal();
}
