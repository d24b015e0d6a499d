package tellosimulator.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;

/** Checks that the notice has each bundled library, with a licence whose text is in the program. */
class LicensesIT {

  private static final Path PROGRAM =
      Path.of(System.getProperty("simulator.jar", "target/tello-simulator.jar"));

  /** A line of THIRD-PARTY.txt, such as {@code (EPL-2.0) (LGPL-2.1-only) Name (g:a:v - url)}. */
  private static final Pattern LIBRARY =
      Pattern.compile("(?m)^ +((?:\\([^)]+\\) )+).* \\([\\w.-]+:([\\w.-]+):[\\w.-]+ - [^)]*\\)$");

  private static final Pattern LICENSE = Pattern.compile("\\(([^)]+)\\)");

  /** The first line of a paragraph of the notice, such as {@code SLF4J (slf4j-api, slf4j-x)}. */
  private static final Pattern HEADING = Pattern.compile("\\A[^\\n]+ \\(([\\w., -]+)\\)\\n");

  private static final Pattern FILE =
      Pattern.compile("META-INF/(?:LICENSE|licenses/([\\w.-]*\\w))");

  @Test
  void theNoticeNamesTheLibrariesOfTheProgramAndNoOthers() throws IOException {
    assertThat(paragraphs().keySet())
        .isNotEmpty()
        .containsExactlyInAnyOrderElementsOf(licenses().keySet());
  }

  @Test
  void theTextOfOneOfItsLicensesIsInTheProgram() throws IOException {
    Map<String, String> paragraphs = paragraphs();
    for (Map.Entry<String, List<String>> library : licenses().entrySet()) {
      assertThat(filesNamedIn(paragraphs.get(library.getKey())))
          .as("licences of %s", library)
          .anyMatch(file -> library.getValue().stream().anyMatch(file::startsWith));
    }
  }

  @Test
  void eachFileThatTheNoticeNamesIsInTheProgram() throws IOException {
    try (ZipFile program = new ZipFile(PROGRAM.toFile())) {
      assertThat(FILE.matcher(read("META-INF/NOTICE")).results().map(MatchResult::group))
          .isNotEmpty()
          .allMatch(file -> program.getEntry(file) != null && program.getEntry(file).getSize() > 0);
    }
  }

  /** Returns the licence files named in a paragraph; that of Apache-2.0 is the program's own. */
  private static List<String> filesNamedIn(String paragraph) {
    return FILE.matcher(paragraph)
        .results()
        .map(file -> file.group(1) == null ? "Apache-2.0" : file.group(1))
        .toList();
  }

  /** Returns the SPDX identifiers of the licences of each library, by the name of its artifact. */
  private static Map<String, List<String>> licenses() throws IOException {
    return LIBRARY
        .matcher(read("META-INF/licenses/THIRD-PARTY.txt"))
        .results()
        .collect(
            Collectors.toMap(
                library -> library.group(2),
                library ->
                    LICENSE.matcher(library.group(1)).results().map(one -> one.group(1)).toList()));
  }

  /** Returns the paragraph of the notice on each library, by the name of its artifact. */
  private static Map<String, String> paragraphs() throws IOException {
    return Arrays.stream(read("META-INF/NOTICE").split("\n\n", -1))
        .flatMap(
            paragraph ->
                HEADING
                    .matcher(paragraph)
                    .results()
                    .flatMap(heading -> Stream.of(heading.group(1).split(", ", -1)))
                    .map(artifact -> Map.entry(artifact, paragraph)))
        .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue));
  }

  private static String read(String path) throws IOException {
    try (ZipFile program = new ZipFile(PROGRAM.toFile())) {
      ZipEntry entry = program.getEntry(path);
      assertThat(entry).as(path).isNotNull();
      try (InputStream in = program.getInputStream(entry)) {
        return new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
      }
    }
  }
}
