// frond-image: decodes or encodes one picture and ends. Started by image_process.c and by nobody else.
//
//     frond-image read FORMAT WIDTH HEIGHT CHANNELS MEGABYTES SECONDS SHRINK   the file on 0, an image_reply to 1
//     frond-image write png WIDTH HEIGHT SECONDS                          rgb bytes on 0, the file to 1
//     frond-image write openexr WIDTH HEIGHT SECONDS NAME...              planes of floats on 0, the file to 1
//
// Exits as image_process.h says; a write that failed leaves an image_reply in place of the file. Both descriptors are
// files that can seek. All that OpenImageIO loads is loaded before image_sandbox_enter; no byte of the picture is
// touched before it.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <new>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "image_sandbox.h"

extern "C" {
#include "image_process.h"
#include "image_reply.h"

#ifdef FROND_SANITIZE_THREAD
// OpenImageIO has a thread of its own at the start and guards its strings with locks that the sanitizer cannot see, as
// it is compiled without it. To report what looks like a race there the sanitizer opens /proc/self/maps, and the
// sandbox kills.
const char *__tsan_default_options()
{
    return "ignore_noninstrumented_modules=1";
}
#endif
}

namespace
{

constexpr int band_bytes = 1 << 20; // of floats decoded at a time: memory stays small beside what decoders take
constexpr int exr_block = 16;       // scanlines that a zip block of an EXR holds
constexpr int write_megabytes = 1024;
constexpr int native_megabytes = 256; // of pixels as the file stores them

[[noreturn]] void quit(int status)
{
    // No destructors and no hooks, the sanitizers' among them: they may call what the filter does not let through.
    syscall(SYS_exit_group, status);
    std::abort();
}

void put(const void *bytes, size_t size, off_t offset)
{
    const char *at = static_cast<const char *>(bytes);
    while (size > 0) {
        ssize_t written = pwrite(1, at, size, offset);
        if (written <= 0) {
            quit(IMAGE_EXIT_USAGE);
        }
        at += written;
        offset += written;
        size -= static_cast<size_t>(written);
    }
}

struct image_reply make_reply(image_reply_status status)
{
    struct image_reply reply = {};
    reply.magic = IMAGE_REPLY_MAGIC;
    reply.status = status;
    reply.orientation = 1;
    reply.alpha = -1;
    return reply;
}

[[noreturn]] void answer(const struct image_reply &reply, int status)
{
    char page[IMAGE_REPLY_VALUES] = {};
    std::memcpy(page, &reply, sizeof reply);
    put(page, sizeof page, 0);
    quit(status);
}

[[noreturn]] void refuse(image_reply_status status, const std::string &message = "")
{
    struct image_reply reply = make_reply(status);
    std::string line = message.substr(0, message.find('\n'));
    std::snprintf(reply.message, sizeof reply.message, "%s", line.empty() ? "no reason given" : line.c_str());
    answer(reply, IMAGE_EXIT_REFUSED);
}

[[noreturn]] void refuse_size(image_reply_status status, const OIIO::ImageSpec &spec)
{
    struct image_reply reply = make_reply(status);
    reply.width = static_cast<uint32_t>(spec.width);
    reply.height = static_cast<uint32_t>(spec.height);
    reply.channels = static_cast<uint32_t>(spec.nchannels);
    answer(reply, IMAGE_EXIT_REFUSED);
}

int number(const char *text, int most)
{
    char *end = nullptr;
    long value = std::strtol(text, &end, 10);
    if (end == text || *end || value < 1 || value > most) {
        quit(IMAGE_EXIT_USAGE);
    }
    return static_cast<int>(value);
}

void sandbox(int megabytes, int seconds, uint64_t file_bytes)
{
    struct image_sandbox_def def = image_sandbox_default_def();
    def.memory_megabytes = megabytes;
    def.cpu_seconds = seconds;
    def.file_bytes = file_bytes;
    if (image_sandbox_enter(&def)) {
        quit(IMAGE_EXIT_UNSAFE);
    }
}

struct read_limits {
    int width, height, channels, megabytes;
    int shrink; // pixels of the longer side that comes out
};

// Pixels along the side of the blocks that become one.
int block_of(const OIIO::ImageSpec &spec, const read_limits &limits)
{
    int longer = spec.width > spec.height ? spec.width : spec.height;
    return (longer + limits.shrink - 1) / limits.shrink;
}

// How many blocks cover a side.
int blocks(int pixels, int block)
{
    return (pixels + block - 1) / block;
}

// The inverse of the sRGB transfer function, IEC 61966-2-1.
float linear_of(float encoded)
{
    double v = encoded;
    return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

// Integer files are sRGB unless they say that they are linear.
class to_linear
{
  public:
    explicit to_linear(const OIIO::ImageSpec &spec) : m_channels(spec.nchannels), m_alpha(spec.alpha_channel)
    {
        // "Linear" in OpenImageIO 2.4, "lin_srgb" and the like later.
        std::string space = std::string(spec.get_string_attribute("oiio:ColorSpace")).substr(0, 3);
        m_encoded = !spec.format.is_floating_point() && space != "Lin" && space != "lin";
        m_associated = m_alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
        m_top = spec.format.basesize() == 1 ? 255.0f : 65535.0f;
        for (int i = 0; m_encoded && i <= static_cast<int>(m_top); i++) {
            m_table.push_back(linear_of(static_cast<float>(i) / m_top));
        }
    }

    void convert(float *pixel) const
    {
        float alpha = m_associated ? pixel[m_alpha] : 1.0f;
        for (int c = 0; c < m_channels; c++) {
            if (c == m_alpha) {
                continue;
            }
            if (alpha != 1.0f && alpha > 0.0f) {
                pixel[c] /= alpha;
            }
            if (m_encoded) {
                float share = pixel[c] < 0.0f ? 0.0f : pixel[c] > 1.0f ? 1.0f : pixel[c];
                pixel[c] = m_table[static_cast<size_t>(std::lround(share * m_top))];
            }
        }
    }

  private:
    int m_channels, m_alpha;
    bool m_encoded, m_associated;
    float m_top;
    std::vector<float> m_table;
};

void check_size(const OIIO::ImageSpec &spec, const read_limits &limits)
{
    if (spec.width > limits.width || spec.height > limits.height) {
        refuse_size(IMAGE_REPLY_SIZE, spec);
    }
    if (spec.nchannels > limits.channels) {
        refuse_size(IMAGE_REPLY_CHANNELS, spec);
    }
}

void check(const OIIO::ImageSpec &spec, const read_limits &limits)
{
    check_size(spec, limits);
    if (spec.deep || spec.depth > 1) {
        refuse(IMAGE_REPLY_DEEP);
    }
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) {
        refuse(IMAGE_REPLY_DAMAGED, "it has no pixels");
    }
    int block = block_of(spec, limits);
    uint64_t bytes = uint64_t(blocks(spec.width, block)) * uint64_t(blocks(spec.height, block)) *
                     uint64_t(spec.nchannels) * sizeof(float);
    if (bytes > uint64_t(limits.megabytes) << 20) {
        refuse(IMAGE_REPLY_MEMORY);
    }
}

// As what is read counts (image.h).
double finite(float value)
{
    return std::isfinite(value) ? double(value) : 0.0;
}

// Takes rows of pixels, gives rows of blocks: the mean of linear light, of colours by their alpha.
class shrinker
{
  public:
    shrinker(const OIIO::ImageSpec &spec, int block)
        : m_block(block), m_width(spec.width), m_channels(spec.nchannels), m_alpha(spec.alpha_channel),
          m_sums(size_t(blocks(spec.width, block)) * size_t(spec.nchannels)), m_out(m_sums.size())
    {
    }

    void add(const float *row)
    {
        for (int x = 0; x < m_width; x++, row += m_channels) {
            double *sum = &m_sums[size_t(x / m_block) * size_t(m_channels)];
            double weight = m_alpha >= 0 ? finite(row[m_alpha]) : 1.0;
            for (int c = 0; c < m_channels; c++) {
                sum[c] += c == m_alpha ? weight : weight * finite(row[c]);
            }
        }
        m_rows++;
    }

    bool is_full() const
    {
        return m_rows == m_block;
    }

    // Of what has been added since the last one.
    const std::vector<float> &take()
    {
        for (size_t i = 0; i < m_sums.size(); i += size_t(m_channels)) {
            int left = int(i / size_t(m_channels)) * m_block,
                right = left + m_block < m_width ? left + m_block : m_width;
            double pixels = double(m_rows) * double(right - left);
            double weight = m_alpha >= 0 ? m_sums[i + size_t(m_alpha)] : pixels;
            for (size_t c = 0; c < size_t(m_channels); c++) {
                double all = int(c) == m_alpha ? pixels : weight;
                m_out[i + c] = all > 0.0 ? static_cast<float>(m_sums[i + c] / all) : 0.0f;
            }
        }
        std::fill(m_sums.begin(), m_sums.end(), 0.0);
        m_rows = 0;
        return m_out;
    }

  private:
    int m_block, m_width, m_channels, m_alpha, m_rows = 0;
    std::vector<double> m_sums;
    std::vector<float> m_out;
};

// A band of rows, smaller; returns where what follows goes.
off_t put_shrunk(shrinker &shrink, const float *values, size_t row, int rows, bool last, off_t offset)
{
    for (int y = 0; y < rows; y++) {
        shrink.add(values + size_t(y) * row);
        if (shrink.is_full() || (last && y == rows - 1)) {
            const std::vector<float> &out = shrink.take();
            put(out.data(), out.size() * sizeof(float), offset);
            offset += static_cast<off_t>(out.size() * sizeof(float));
        }
    }
    return offset;
}

void read_values(OIIO::ImageInput &input, const OIIO::ImageSpec &spec, int block)
{
    int row = spec.width * spec.nchannels;
    int band = spec.tile_width ? spec.tile_height : band_bytes / (row * int(sizeof(float)));
    band = band < 1 ? 1 : band > spec.height ? spec.height : band;
    std::vector<float> values(size_t(row) * size_t(band));
    to_linear linear(spec);
    shrinker shrink(spec, block);
    off_t offset = IMAGE_REPLY_VALUES;
    for (int y = 0; y < spec.height; y += band) {
        int rows = band < spec.height - y ? band : spec.height - y;
        int top = spec.y + y;
        bool read = spec.tile_width ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, top, top + rows, spec.z,
                                                       spec.z + 1, 0, spec.nchannels, OIIO::TypeFloat, values.data())
                                    : input.read_scanlines(0, 0, top, top + rows, spec.z, 0, spec.nchannels,
                                                           OIIO::TypeFloat, values.data());
        if (!read) {
            refuse(IMAGE_REPLY_DAMAGED, input.geterror());
        }
        for (size_t i = 0; i < size_t(row) * size_t(rows); i += size_t(spec.nchannels)) {
            linear.convert(&values[i]);
        }
        if (block > 1) {
            offset = put_shrunk(shrink, values.data(), size_t(row), rows, y + rows == spec.height, offset);
            continue;
        }
        size_t bytes = size_t(row) * size_t(rows) * sizeof(float);
        put(values.data(), bytes, offset);
        offset += static_cast<off_t>(bytes);
    }
}

std::unique_ptr<OIIO::ImageInput> make_reader(const std::string &format)
{
    auto input = OIIO::ImageInput::create(format);
    if (!input || format != input->format_name() || !input->supports("ioproxy")) {
        quit(IMAGE_EXIT_USAGE);
    }
    return input;
}

[[noreturn]] void read_picture(const std::string &format, const read_limits &limits, int seconds)
{
    OIIO::attribute("limits:channels", limits.channels);
    auto input = make_reader(format);
    struct stat file;
    if (fstat(0, &file) != 0 || file.st_size < 1) {
        quit(IMAGE_EXIT_USAGE);
    }
    size_t size = static_cast<size_t>(file.st_size);
    void *bytes = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, 0, 0);
    if (bytes == MAP_FAILED) {
        refuse(IMAGE_REPLY_MEMORY);
    }
    sandbox(limits.megabytes, seconds, IMAGE_REPLY_VALUES + (uint64_t(limits.megabytes) << 20));

    OIIO::Filesystem::IOMemReader memory(bytes, size);
    OIIO::ImageSpec config, spec;
    config.attribute("oiio:UnassociatedAlpha", 1);
    bool opened = input->set_ioproxy(&memory) && input->open("picture", spec, config);
    if (!opened) {
        check_size(input->spec(), limits); // says more than the decoder does when it gave up over the size
        refuse(IMAGE_REPLY_DAMAGED, input->geterror());
    }
    check(spec, limits);
    int block = block_of(spec, limits);
    read_values(*input, spec, block);
    struct image_reply reply = make_reply(IMAGE_REPLY_OK);
    reply.width = static_cast<uint32_t>(blocks(spec.width, block));
    reply.height = static_cast<uint32_t>(blocks(spec.height, block));
    reply.channels = static_cast<uint32_t>(spec.nchannels);
    reply.alpha = spec.alpha_channel;
    int orientation = spec.get_int_attribute("Orientation", 1);
    reply.orientation = orientation >= 1 && orientation <= 8 ? static_cast<uint32_t>(orientation) : 1;
    for (size_t c = 0; c < spec.channelnames.size() && c < IMAGE_CHANNELS_MAX; c++) {
        std::snprintf(reply.names[c], IMAGE_NAME, "%s", spec.channelnames[c].c_str());
    }
    answer(reply, IMAGE_EXIT_DONE);
}

void get(void *bytes, size_t size, off_t offset)
{
    if (pread(0, bytes, size, offset) != static_cast<ssize_t>(size)) {
        quit(IMAGE_EXIT_USAGE);
    }
}

// Bytes of rgb, interleaved as they came.
bool write_bytes(OIIO::ImageOutput &output, const OIIO::ImageSpec &spec)
{
    size_t row = size_t(spec.width) * size_t(spec.nchannels);
    std::vector<unsigned char> values(row);
    for (int y = 0; y < spec.height; y++) {
        get(values.data(), row, static_cast<off_t>(size_t(y) * row));
        if (!output.write_scanline(y, 0, OIIO::TypeUInt8, values.data())) {
            return false;
        }
    }
    return true;
}

// Planes of floats, one after the other.
bool write_planes(OIIO::ImageOutput &output, const OIIO::ImageSpec &spec)
{
    size_t width = size_t(spec.width), channels = size_t(spec.nchannels), plane = width * size_t(spec.height);
    std::vector<float> rows(width * exr_block), values(rows.size() * channels);
    for (int y = 0; y < spec.height; y += exr_block) {
        int count = exr_block < spec.height - y ? exr_block : spec.height - y;
        size_t cells = width * size_t(count);
        for (size_t c = 0; c < channels; c++) {
            get(rows.data(), cells * sizeof(float),
                static_cast<off_t>((c * plane + size_t(y) * width) * sizeof(float)));
            for (size_t i = 0; i < cells; i++) {
                values[i * channels + c] = rows[i];
            }
        }
        if (!output.write_scanlines(y, y + count, 0, OIIO::TypeFloat, values.data())) {
            return false;
        }
    }
    return true;
}

[[noreturn]] void write_picture(const std::string &format, int width, int height, int seconds, char **names, int count)
{
    bool png = format == "png";
    OIIO::ImageSpec spec(width, height, png ? 3 : count, png ? OIIO::TypeUInt8 : OIIO::TypeFloat);
    if (png) {
        spec.attribute("oiio:ColorSpace", "sRGB");
    } else {
        spec.channelnames.assign(names, names + count);
        spec.attribute("compression", "zip");
    }
    auto output = OIIO::ImageOutput::create(format);
    FILE *file = fdopen(1, "w+b");
    if (!output || !file || !output->supports("ioproxy")) {
        quit(IMAGE_EXIT_USAGE);
    }
    sandbox(write_megabytes, seconds, UINT64_C(1) << 40);
    OIIO::Filesystem::IOFile proxy(file, OIIO::Filesystem::IOProxy::Write);
    bool written = output->set_ioproxy(&proxy) && output->open("picture", spec) &&
                   (png ? write_bytes(*output, spec) : write_planes(*output, spec)) && output->close() &&
                   std::fflush(file) == 0;
    if (!written) {
        refuse(IMAGE_REPLY_DAMAGED, output->geterror());
    }
    quit(IMAGE_EXIT_DONE);
}

void serve(int argc, char **argv)
{
    std::string order = argc > 2 ? argv[1] : "", format = argc > 2 ? argv[2] : "";
    // The date in an EXR is the only use of a time zone, and a zone would be a file.
    setenv("TZ", "UTC0", 1);
    tzset();
    // No threads: the filter forbids them. -1 tells OpenEXR to work on the caller's own.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    OIIO::attribute("limits:imagesize_MB", native_megabytes);
    if (order == "read" && argc == 9) {
        read_limits limits = {number(argv[3], IMAGE_SIZE_MAX), number(argv[4], IMAGE_SIZE_MAX),
                              number(argv[5], IMAGE_CHANNELS_MAX), number(argv[6], 4096),
                              number(argv[8], IMAGE_SIZE_MAX)};
        read_picture(format, limits, number(argv[7], 600));
    }
    if (order == "write" && argc >= 6 && (format == "png" ? argc == 6 : format == "openexr" && argc > 6)) {
        write_picture(format, number(argv[3], IMAGE_SIZE_MAX), number(argv[4], IMAGE_SIZE_MAX), number(argv[5], 600),
                      argv + 6, argc - 6);
    }
}

} // namespace

int main(int argc, char **argv)
{
    try {
        serve(argc, argv);
    } catch (const std::bad_alloc &) {
        refuse(IMAGE_REPLY_MEMORY);
    } catch (const std::exception &problem) {
        refuse(IMAGE_REPLY_DAMAGED, problem.what());
    }
    std::fputs("frond-image is started by frond to read and write pictures; it does nothing by itself\n", stderr);
    return IMAGE_EXIT_USAGE;
}
