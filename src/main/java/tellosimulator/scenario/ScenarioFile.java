package tellosimulator.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.files.AtomicFile;
import tellosimulator.files.IrregularFileException;
import tellosimulator.scenario.ScenarioCodec.Noted;

/** A scenario as a YAML file. For any thread. */
public final class ScenarioFile {

  private ScenarioFile() {}

  /**
   * Reads a file.
   *
   * @throws ScenarioException with all that is wrong with it
   */
  public static Scenario read(Path file) throws ScenarioException {
    return open(file).scenario();
  }

  /**
   * Reads a file, to change and to save it.
   *
   * @throws ScenarioException with all that is wrong with it
   */
  public static ScenarioDocument open(Path file) throws ScenarioException {
    Diagnostics diagnostics = new Diagnostics(file.toString());
    Optional<byte[]> bytes = new Source(file.toString(), diagnostics).bytes(file);
    diagnostics.check();
    return open(file.toString(), bytes.orElseThrow(), folder(file));
  }

  /** Reads what came with the program. */
  static ScenarioDocument open(String name, InputStream input)
      throws IOException, ScenarioException {
    return open(name, input.readAllBytes(), Path.of(""));
  }

  private static ScenarioDocument open(String name, byte[] bytes, Path folder)
      throws ScenarioException {
    Diagnostics diagnostics = new Diagnostics(name);
    Source source = new Source(name, diagnostics);
    Optional<String> text = source.text(bytes);
    Optional<Node> root = text.isPresent() ? source.root(text.get()) : Optional.empty();
    diagnostics.check();
    Codec.Context context = new Codec.Context(diagnostics, folder, true, 1);
    Optional<Noted> noted = ScenarioCodec.CODEC.read(root.orElseThrow(), context);
    diagnostics.check();
    return ScenarioDocument.read(
        noted.orElseThrow(), new String(bytes, StandardCharsets.UTF_8), folder);
  }

  /**
   * What a text says whose parts need not go together: a goal may name a gate that is not there.
   *
   * @return empty if a part of it could not be read
   */
  static Optional<Noted> understood(String text, Path folder) {
    Diagnostics diagnostics = new Diagnostics("");
    Codec.Context context = new Codec.Context(diagnostics, folder, false, 1);
    return new Source("", diagnostics)
        .root(text)
        .flatMap(root -> ScenarioCodec.CODEC.read(root, context));
  }

  /** The folder of a file. */
  public static Path folder(Path file) {
    return Optional.ofNullable(file.getParent()).orElse(Path.of(""));
  }

  /**
   * Whether a file holds what a document says; also if it is not there, because then nothing of it
   * can be lost.
   *
   * @throws IOException if it cannot be read
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
   * Writes a file anew that reads back as an equal scenario, but for lengths and angles below a
   * millionth of a centimetre and a degree.
   *
   * @throws IOException if it cannot be written
   */
  static void write(Scenario scenario, Path file) throws IOException {
    write(ScenarioDocument.of(scenario).changedTo(scenario, folder(file)), file);
  }

  /**
   * Writes all of a document to a file, or leaves the file as it is.
   *
   * @throws IOException if it cannot be written
   */
  public static void write(ScenarioDocument document, Path file) throws IOException {
    AtomicFile.write(file, out -> out.write(document.bytes().orElseThrow()));
  }
}
