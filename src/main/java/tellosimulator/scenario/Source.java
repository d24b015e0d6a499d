package tellosimulator.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.common.SpecVersion;
import org.snakeyaml.engine.v2.composer.Composer;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.ReaderException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlVersionException;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.parser.Parser;
import org.snakeyaml.engine.v2.parser.ParserImpl;
import org.snakeyaml.engine.v2.scanner.StreamReader;
import org.snakeyaml.engine.v2.schema.FailsafeSchema;
import tellosimulator.scenario.Diagnostic.Place;
import tellosimulator.words.Phrase;

/** Parses the text of a file into nodes. Time and memory are bounded for any content. */
final class Source {

  /** Maximum size of a file [bytes]. Decided: enough for about ten thousand obstacles. */
  static final int LARGEST = 4 << 20;

  /**
   * Maximum length of a quoted message of the YAML library [characters]; longer messages are
   * truncated. Decided.
   */
  private static final int LONGEST_SHOWN = 120;

  /** Matches the messages of the YAML library about text that needs quotes. */
  private static final Pattern NEEDS_QUOTES =
      Pattern.compile("mapping values are not allowed|cannot start any token");

  private static final char BYTE_ORDER_MARK = '\uFEFF';

  private final String file;
  private final Diagnostics diagnostics;

  Source(String file, Diagnostics diagnostics) {
    this.file = file;
    this.diagnostics = diagnostics;
  }

  /** Reads the bytes of a file; returns empty if the file cannot be read or is too large. */
  Optional<byte[]> bytes(Path path) {
    if (Files.isDirectory(path)) {
      diagnostics.add(Place.WHOLE, Phrase.of("expected a file, found a folder"));
      return Optional.empty();
    }
    if (!Files.exists(path)) {
      diagnostics.add(Place.WHOLE, Phrase.of("there is no such file"));
      return Optional.empty();
    }
    if (!Files.isRegularFile(path)) { // a pipe may block forever, and a device may never end
      diagnostics.add(Place.WHOLE, Phrase.of("expected a file, found a pipe or a device"));
      return Optional.empty();
    }
    try (InputStream input = Files.newInputStream(path)) {
      byte[] bytes = input.readNBytes(LARGEST + 1);
      if (bytes.length > LARGEST) {
        diagnostics.add(
            Place.WHOLE,
            Phrase.of("expected a file of at most %d MB, found a larger one", LARGEST >> 20));
        return Optional.empty();
      }
      return Optional.of(bytes);
    } catch (IOException e) {
      diagnostics.add(Place.WHOLE, Phrase.of("the file cannot be read"));
      return Optional.empty();
    }
  }

  /** Decodes UTF-8; returns empty if the bytes are not valid UTF-8. */
  Optional<String> text(byte[] bytes) {
    CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder();
    CharBuffer chars = CharBuffer.allocate(bytes.length + 1);
    CoderResult result = decoder.decode(ByteBuffer.wrap(bytes), chars, true);
    String text = chars.flip().toString();
    if (result.isError()) {
      diagnostics.add(end(text), Phrase.of("expected text in UTF-8, found other bytes"));
      return Optional.empty();
    }
    boolean marked = !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK;
    return Optional.of(marked ? text.substring(1) : text);
  }

  /**
   * Parses the text. If the text is empty, is not YAML or exceeds a limit, reports an error and
   * returns empty.
   */
  Optional<Node> root(String text) {
    LoadSettings settings = settings(text);
    try {
      Parser parser = new ParserImpl(settings, new StreamReader(settings, text));
      Optional<Node> root = new Composer(settings, new BoundedParser(parser)).getSingleNode();
      if (root.isEmpty()) {
        diagnostics.add(new Place(1, 1), Phrase.of("the file is empty"));
      }
      return root;
    } catch (BoundedParser.ExceededException e) {
      diagnostics.add(e.place(), e.phrase());
    } catch (MarkedYamlEngineException e) {
      Place place =
          e.getProblemMark().or(e::getContextMark).map(Diagnostics::place).orElse(Place.WHOLE);
      String problem = shortened(String.valueOf(e.getProblem()).replaceFirst("\\. \\(.*", ""));
      diagnostics.add(
          place,
          NEEDS_QUOTES.matcher(problem).find()
              ? Phrase.of(
                  "this is not YAML: %s; text with a colon or a sign such as @ needs quotes, as in"
                      + " name: \"Slalom: the race\"",
                  problem)
              : Phrase.of("this is not YAML: %s", problem));
    } catch (YamlVersionException e) {
      SpecVersion version = e.getSpecVersion();
      diagnostics.add(
          Place.WHOLE,
          Phrase.of("expected YAML 1.2, found %d.%d", version.getMajor(), version.getMinor()));
    } catch (ReaderException e) {
      int codePoints = Math.min(e.getPosition(), text.codePointCount(0, text.length()));
      Place place = end(text.substring(0, text.offsetByCodePoints(0, codePoints)));
      diagnostics.add(
          place, Phrase.of("expected text, found the control character %d", e.getCodePoint()));
    } catch (YamlEngineException e) {
      diagnostics.add(Place.WHOLE, Phrase.of("this is not YAML: %s", shortened(e.getMessage())));
    }
    return Optional.empty();
  }

  /**
   * Returns settings with which the whole text is read into one buffer. With several buffers, a
   * word that extends over several of them would be copied once per buffer, and each mark would
   * retain a buffer. Measured with several buffers: a line of 4 MB took 20 s and 1.5 GB.
   */
  private LoadSettings settings(String text) {
    return LoadSettings.builder()
        .setLabel(file)
        .setCodePointLimit(LARGEST)
        .setSchema(new FailsafeSchema()) // codecs parse all scalars as strings
        .setAllowNonScalarKeys(true) // codecs reject such keys, and report where they are
        .setBufferSize(text.length() + 2) // the reader needs two spare characters
        .build();
  }

  /** Returns the position of the end of a text. */
  private static Place end(String text) {
    int line = 1 + (int) text.chars().filter(c -> c == '\n').count();
    int column = text.length() - text.lastIndexOf('\n');
    return new Place(line, column);
  }

  /** Shortens a message of the YAML library, which may quote the whole file. */
  private static String shortened(String message) {
    String line = message.lines().findFirst().orElse("");
    return line.length() <= LONGEST_SHOWN ? line : line.substring(0, LONGEST_SHOWN) + "…";
  }
}
