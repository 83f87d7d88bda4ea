// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

using Bytes = std::span<const std::byte>;

inline Bytes asBytes(QByteArrayView view)
{
    return {reinterpret_cast<const std::byte *>(view.data()), static_cast<std::size_t>(view.size())};
}

inline QByteArray toByteArray(Bytes bytes)
{
    return QByteArray(reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()));
}

/// Reads little-endian fields one after the other. Failure is sticky: read all fields, then ask ok() once.
class ByteReader
{
public:
    explicit ByteReader(Bytes bytes)
        : m_bytes(bytes)
    {
    }
    explicit ByteReader(QByteArrayView view)
        : m_bytes(asBytes(view))
    {
    }
    explicit ByteReader(const QByteArray &bytes)
        : ByteReader(QByteArrayView(bytes))
    {
    }
    explicit ByteReader(const QByteArray &&) = delete;  // the bytes would be destroyed before they are read

    [[nodiscard]] bool ok() const { return m_ok; }
    [[nodiscard]] std::size_t position() const { return m_position; }
    [[nodiscard]] std::size_t remaining() const { return m_bytes.size() - m_position; }

    /// Next field of type T (an integer or float), or T{} past the end.
    template <typename T> T read()
    {
        static_assert(std::is_arithmetic_v<T>);
        T value{};
        const Bytes field = take(sizeof(T));
        if (field.size() == sizeof(T))
            std::memcpy(&value, field.data(), sizeof(T));
        return value;
    }

    std::uint8_t u8() { return read<std::uint8_t>(); }
    std::int8_t i8() { return read<std::int8_t>(); }
    std::uint16_t u16() { return read<std::uint16_t>(); }
    std::int16_t i16() { return read<std::int16_t>(); }
    std::uint32_t u32() { return read<std::uint32_t>(); }
    std::int32_t i32() { return read<std::int32_t>(); }
    float f32() { return read<float>(); }

    /// The next n bytes, or nothing when fewer are left.
    Bytes take(std::size_t count)
    {
        if (!m_ok || remaining() < count) {
            m_ok = false;
            return {};
        }
        const Bytes field = m_bytes.subspan(m_position, count);
        m_position += count;
        return field;
    }

    void skip(std::size_t count) { take(count); }

private:
    static_assert(std::endian::native == std::endian::little,
                  "wire fields are copied, so the host is little-endian");
    Bytes m_bytes;
    std::size_t m_position = 0;
    bool m_ok = true;
};

/// Appends little-endian fields to a byte array.
class ByteWriter
{
public:
    template <typename T> ByteWriter &write(T value)
    {
        static_assert(std::is_arithmetic_v<T>);
        m_bytes.append(reinterpret_cast<const char *>(&value), sizeof(T));
        return *this;
    }

    ByteWriter &u8(int value) { return write(static_cast<std::uint8_t>(value)); }
    ByteWriter &i8(int value) { return write(static_cast<std::int8_t>(value)); }
    ByteWriter &u16(int value) { return write(static_cast<std::uint16_t>(value)); }
    ByteWriter &i16(int value) { return write(static_cast<std::int16_t>(value)); }
    ByteWriter &u32(std::uint32_t value) { return write(value); }
    ByteWriter &i32(std::int32_t value) { return write(value); }
    ByteWriter &f32(float value) { return write(value); }
    ByteWriter &bytes(QByteArrayView view)
    {
        m_bytes.append(view);
        return *this;
    }
    ByteWriter &zeros(int count)
    {
        m_bytes.append(count, '\0');
        return *this;
    }

    [[nodiscard]] qsizetype size() const { return m_bytes.size(); }
    [[nodiscard]] QByteArray take() { return std::move(m_bytes); }

private:
    QByteArray m_bytes;
};
