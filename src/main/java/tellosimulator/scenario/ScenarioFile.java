package tellosimulator.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;

/** A scenario as a YAML file. For any thread. */
public final class ScenarioFile {

  private ScenarioFile() {}

  /**
   * Reads a file.
   *
   * @throws ScenarioException with all that is wrong with it
   */
  public static Scenario read(Path file) throws ScenarioException {
    Mistakes mistakes = new Mistakes(file.toString());
    Optional<byte[]> bytes = new Source(file.toString(), mistakes).bytes(file);
    mistakes.check();
    return read(file.toString(), bytes.orElseThrow(), folder(file));
  }

  /** Reads what came with the program. */
  static Scenario read(String name, InputStream input) throws IOException, ScenarioException {
    return read(name, input.readAllBytes(), Path.of(""));
  }

  private static Scenario read(String name, byte[] bytes, Path folder) throws ScenarioException {
    Mistakes mistakes = new Mistakes(name);
    Source source = new Source(name, mistakes);
    Optional<String> text = source.text(bytes);
    Optional<Node> root = text.isPresent() ? source.root(text.get()) : Optional.empty();
    mistakes.check();
    Scenario scenario = new ScenarioReader(root.orElseThrow(), folder, mistakes).read();
    mistakes.check();
    return scenario;
  }

  /**
   * Writes a file that reads back as an equal scenario, but for lengths and angles below a
   * millionth of a centimetre and a degree. Comments of a file that was there are lost.
   *
   * @throws IOException if it cannot be written
   */
  public static void write(Scenario scenario, Path file) throws IOException {
    String text = new ScenarioWriter(folder(file)).text(scenario);
    Path beside = Files.createTempFile(file.toAbsolutePath().getParent(), "scenario", ".tmp");
    try {
      Files.writeString(beside, text, StandardCharsets.UTF_8);
      Files.move(beside, file, StandardCopyOption.REPLACE_EXISTING); // all of it, or nothing
    } finally {
      Files.deleteIfExists(beside);
    }
  }

  private static Path folder(Path file) {
    return Optional.ofNullable(file.getParent()).orElse(Path.of(""));
  }
}
