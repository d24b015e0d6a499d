package tellosimulator.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalLong;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.files.AtomicFile;
import tellosimulator.files.IrregularFileException;
import tellosimulator.scenario.ScenarioCodec.ParsedScenario;

/** Reads and writes scenarios as YAML files. Thread-safe. */
public final class ScenarioFile {

  /** Maximum number of attempts to draw a course without contradictions. Decided. */
  private static final int MOST_ATTEMPTS = 100;

  private ScenarioFile() {}

  /**
   * Reads a scenario from a file.
   *
   * @throws ScenarioException if the file cannot be read or contains errors; the exception lists
   *     all of them
   */
  public static Scenario read(Path file) throws ScenarioException {
    return open(file).scenario();
  }

  /**
   * Reads a scenario from a file, together with its text, for editing and saving. Numbers for its
   * ranges are drawn from the seed in the file.
   *
   * @throws ScenarioException if the file cannot be read or contains errors; the exception lists
   *     all of them
   */
  public static ScenarioDocument open(Path file) throws ScenarioException {
    Diagnostics diagnostics = new Diagnostics(file.toString());
    Optional<byte[]> bytes = new Source(file.toString(), diagnostics).bytes(file);
    diagnostics.check();
    return open(file.toString(), bytes.orElseThrow(), folder(file), OptionalLong.empty());
  }

  /** Reads a scenario that comes with the program. */
  static ScenarioDocument open(String name, InputStream input)
      throws IOException, ScenarioException {
    return open(name, input.readAllBytes(), Path.of(""), OptionalLong.empty());
  }

  /**
   * Reads the content of a file.
   *
   * @param seed the seed from which the course is drawn; if empty, that in the file
   */
  static ScenarioDocument open(String name, byte[] bytes, Path folder, OptionalLong seed)
      throws ScenarioException {
    Diagnostics diagnostics = new Diagnostics(name);
    Source source = new Source(name, diagnostics);
    Optional<String> text = source.text(bytes);
    Optional<Node> root = text.isPresent() ? source.root(text.get()) : Optional.empty();
    diagnostics.check();
    Node node = root.orElseThrow();
    long drawnFrom = seed.orElseGet(() -> CourseDraw.seedIn(node));
    for (int attempt = 0; attempt < MOST_ATTEMPTS; attempt++) {
      diagnostics = new Diagnostics(name);
      CourseDraw draw = CourseDraw.of(node, drawnFrom, attempt);
      Codec.Context context = new Codec.Context(diagnostics, folder, true, 1, draw);
      Optional<ParsedScenario> noted = ScenarioCodec.CODEC.read(node, context);
      if (draw.isEmpty() || !diagnostics.mayFitAnotherTime()) {
        diagnostics.check();
        return ScenarioDocument.read(
            noted.orElseThrow(), new String(bytes, StandardCharsets.UTF_8), folder, draw);
      }
    }
    throw diagnostics.noCourse(MOST_ATTEMPTS, drawnFrom);
  }

  /**
   * Parses a text whose parts may contradict each other; for example, a goal may name a gate that
   * does not exist.
   *
   * @param draw the draw of another version of the text
   * @return the scenario; empty if a part of it could not be read
   */
  static Optional<ParsedScenario> understood(String text, Path folder, CourseDraw draw) {
    Diagnostics diagnostics = new Diagnostics("");
    return new Source("", diagnostics)
        .root(text)
        .flatMap(
            root ->
                ScenarioCodec.CODEC.read(
                    root, new Codec.Context(diagnostics, folder, false, 1, draw.again(root))));
  }

  /** Returns the folder that contains a file. */
  public static Path folder(Path file) {
    return Optional.ofNullable(file.getParent()).orElse(Path.of(""));
  }

  /**
   * Returns whether a document can be saved to a file without losing any content. This is the case
   * if the file equals the document or does not exist.
   *
   * @throws IOException if the file cannot be read
   */
  public static boolean holds(Path file, ScenarioDocument document) throws IOException {
    if (Files.notExists(file)) {
      return true;
    }
    IrregularFileException.check(file);
    byte[] expected = document.bytes().orElse(new byte[0]);
    try (InputStream input = Files.newInputStream(file)) {
      return Arrays.equals(input.readNBytes(expected.length + 1), expected);
    }
  }

  /**
   * Writes a scenario to a file, and replaces any existing content. Reading the file returns an
   * equal scenario, except for differences in lengths and angles of less than a millionth of a
   * centimetre or degree.
   *
   * @throws IOException if the file cannot be written
   */
  static void write(Scenario scenario, Path file) throws IOException {
    write(ScenarioDocument.of(scenario).changedTo(scenario, folder(file)), file);
  }

  /**
   * Writes a document to a file. If this fails, the file remains unchanged.
   *
   * @throws IOException if the file cannot be written
   */
  public static void write(ScenarioDocument document, Path file) throws IOException {
    AtomicFile.write(file, out -> out.write(document.bytes().orElseThrow()));
  }
}
