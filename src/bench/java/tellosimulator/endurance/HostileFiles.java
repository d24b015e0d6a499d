package tellosimulator.endurance;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;

/** Scenarios that nobody should have to open, and pictures in them. */
final class HostileFiles {

  /** What is no length in cm, with a name for each. */
  private static final List<String> NO_LENGTHS =
      List.of(
          "-1",
          "0",
          "1e309",
          "-1e309",
          ".nan",
          ".inf",
          "1e-300",
          "99999999999999999999",
          "0x7fffffffffffffff",
          "true",
          "null",
          "[]",
          "{}",
          "\"\"",
          "12:30:45",
          "2001-01-01",
          "!!float abc",
          "!!java.net.URL [\"http://127.0.0.1:9/\"]",
          "!!javax.script.ScriptEngineManager [!!java.net.URLClassLoader [[]]]",
          "!!binary AAAA",
          "\"\\0\"",
          "\"\\uD800\"");

  private final Path folder;
  private final Map<String, Path> files = new LinkedHashMap<>();

  private HostileFiles(Path folder) {
    this.folder = folder;
  }

  /** Writes them all; each with the name under which it is told. */
  static Map<String, Path> in(Path folder) throws IOException {
    HostileFiles hostile = new HostileFiles(folder);
    for (String length : NO_LENGTHS) {
      hostile.text("width " + length, "room: {width: " + length + "}\n");
    }
    hostile.structures();
    hostile.sizes();
    hostile.bytes();
    hostile.pictures();
    hostile.places();
    return hostile.files;
  }

  private void structures() throws IOException {
    text("a billion laughs", laughs());
    text("an alias of itself", "obstacles: &a [*a]\n");
    text("an alias of nothing", "name: *nobody\n");
    text("merged maps", "a: &a {b: 1}\nroom: {<<: [*a, *a]}\n");
    text("10,000 lists in each other", "obstacles: " + "[".repeat(10_000) + "\n");
    text("10,000 closed lists", "name: " + "[".repeat(10_000) + "]".repeat(10_000) + "\n");
    text("5,000 maps in each other", "a: " + "{a: ".repeat(5_000) + "\n");
    text("10,000 dashes", "- ".repeat(10_000) + "\n");
    text("10,000 indents", indents());
    text("two documents", "name: a\n---\nname: b\n");
    text("the same key twice", "name: a\nname: b\n");
    text("a list", "- 1\n");
    text("a word", "scenario\n");
    text("a tab", "room:\n\twidth: 500\n");
    text("an open quote", "name: \"" + "x".repeat(1000) + "\n");
    text("a directive", "%YAML 9.9\n---\nname: a\n");
    text("a key that is a map", "{{a: 1}: 2}\n");
    text("NaN in a place", "obstacles:\n  - box: {at: [.nan, .inf], size: [10, 10, 10]}\n");
    text("no time", "time-limit: .nan\n");
  }

  private void sizes() throws IOException {
    text("a scalar of 4 MB", "name: " + "x".repeat(4_000_000) + "\n");
    text("a number of 4 MB", "room: {width: " + "9".repeat(4_000_000) + "}\n");
    text("a key of 4 MB", "x".repeat(4_000_000) + ": 1\n");
    text("a quoted scalar of 4 MB", "name: \"" + "\\n".repeat(2_000_000) + "\"\n");
    text("a folded scalar of 4 MB", "name: >\n" + " x\n".repeat(1_300_000));
    text("100,000 unknown keys", numbered("key%d: 1\n"));
    text("100,000 drones", "drones:\n" + numbered("  - {start: [%d, 0]}\n"));
    text("100,000 mistakes", "obstacles:\n" + numbered("  - box%d: {}\n"));
    text("100,000 anchors", "obstacles:\n" + numbered("  - &a%d {}\n"));
  }

  private void bytes() throws IOException {
    write("bytes that are no UTF-8", new byte[] {'n', ':', ' ', (byte) 0xff, (byte) 0xc0, '\n'});
    write("zeros", new byte[100_000]);
    write("a PNG as scenario", png(10, 10));
    write("half a UTF-16", new byte[] {(byte) 0xff, (byte) 0xfe, 'a'});
  }

  private void pictures() throws IOException {
    picture("a picture of 67,000,000 × 1", png(67_000_000, 1));
    picture("a picture of 1 × 67,000,000", png(1, 67_000_000));
    picture("a picture of 30,000 × 30,000", png(30_000, 30_000));
    picture("a picture of 2,147,483,647 × 2,147,483,647", header(Integer.MAX_VALUE));
    picture("a picture that is cut off", header(1000));
    picture("a picture that is text", "no picture".getBytes(StandardCharsets.UTF_8));
    picture("an empty picture", new byte[0]);
    poster("a picture that is a device", Path.of("/dev/zero"));
    poster("a picture that is a folder", folder);
    poster("a picture that is a FIFO", fifo("picture.png"));
    poster("a picture that is not there", folder.resolve("nowhere.png"));
  }

  private void places() throws IOException {
    files.put("a FIFO", fifo("fifo.yaml"));
    files.put("the device of zeros", Path.of("/dev/zero"));
    files.put("the device of noise", Path.of("/dev/urandom"));
    files.put("a terminal", Path.of("/dev/tty"));
    files.put("a folder", folder);
    files.put("no file", folder.resolve("nowhere.yaml"));
    Path loop = folder.resolve("loop.yaml");
    files.put("a link to itself", Files.createSymbolicLink(loop, loop));
  }

  private static String laughs() {
    StringBuilder text = new StringBuilder("a0: &a0 [x, x, x, x, x, x, x, x, x]\n");
    for (int i = 1; i < 10; i++) {
      text.append("a%d: &a%d [".formatted(i, i));
      text.append("*a%d, ".formatted(i - 1).repeat(9)).append("]\n");
    }
    return text.toString();
  }

  private static String indents() {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 2000; i++) {
      text.append(" ".repeat(i)).append("a:\n");
    }
    return text.toString();
  }

  private static String numbered(String line) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 100_000; i++) {
      text.append(line.formatted(i));
    }
    return text.toString();
  }

  private void text(String name, String text) throws IOException {
    write(name, text.getBytes(StandardCharsets.UTF_8));
  }

  private void write(String name, byte[] bytes) throws IOException {
    files.put(name, Files.write(folder.resolve(files.size() + ".yaml"), bytes));
  }

  private void picture(String name, byte[] bytes) throws IOException {
    poster(name, Files.write(folder.resolve(files.size() + ".png"), bytes));
  }

  private void poster(String name, Path picture) throws IOException {
    text(
        name,
        "posters:\n  - {wall: front, along: 0, height: 120, width: 30, picture: \"%s\"}\n"
            .formatted(picture));
  }

  private Path fifo(String name) throws IOException {
    Path fifo = folder.resolve(name);
    Host.HERE.run("mkfifo", fifo.toString());
    return fifo;
  }

  /** A black picture of one bit a pixel, which packs well. */
  private static byte[] png(int width, int height) throws IOException {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (DeflaterOutputStream rows = new DeflaterOutputStream(packed)) {
      byte[] row = new byte[1 + (width + 7) / 8];
      for (int y = 0; y < height; y++) {
        rows.write(row);
      }
    }
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.writeBytes(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
    chunk(file, "IHDR", size(width, height));
    chunk(file, "IDAT", packed.toByteArray());
    chunk(file, "IEND", new byte[0]);
    return file.toByteArray();
  }

  /** A picture that claims to be large, and of which nothing comes. */
  private static byte[] header(int edge) {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.writeBytes(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
    chunk(file, "IHDR", size(edge, edge));
    return file.toByteArray();
  }

  private static byte[] size(int width, int height) {
    byte[] oneBitGray = {1, 0, 0, 0, 0};
    return ByteBuffer.allocate(13).putInt(width).putInt(height).put(oneBitGray).array();
  }

  private static void chunk(ByteArrayOutputStream file, String type, byte[] data) {
    byte[] name = type.getBytes(StandardCharsets.US_ASCII);
    CRC32 check = new CRC32();
    check.update(name);
    check.update(data);
    file.writeBytes(ByteBuffer.allocate(4).putInt(data.length).array());
    file.writeBytes(name);
    file.writeBytes(data);
    file.writeBytes(ByteBuffer.allocate(4).putInt((int) check.getValue()).array());
  }
}
