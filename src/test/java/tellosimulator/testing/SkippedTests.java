package tellosimulator.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * Prints the tests that a build has skipped, and the reasons. Maven runs it as a single source file
 * at the end of {@code verify}:
 *
 * <pre>java SkippedTests.java TARGET BEGINNING</pre>
 *
 * <p>It reads the XML reports of Surefire and Failsafe below TARGET that are not older than
 * BEGINNING, an instant in ISO 8601.
 */
public final class SkippedTests {

  private SkippedTests() {}

  /** Takes the parent folder of the report folders, and the start time of the build. */
  public static void main(String[] arguments) throws Exception {
    Instant beginning = Instant.parse(arguments[1]);
    Map<String, Integer> skipped = new TreeMap<>();
    for (String folder : List.of("surefire-reports", "failsafe-reports")) {
      for (Path report : reports(Path.of(arguments[0], folder))) {
        if (!Files.getLastModifiedTime(report).toInstant().isBefore(beginning)) {
          count(report, skipped);
        }
      }
    }
    System.out.print(summary(skipped));
  }

  /** Returns one line for each reason. */
  static String summary(Map<String, Integer> skipped) {
    if (skipped.isEmpty()) {
      return "";
    }
    StringBuilder text = new StringBuilder("Skipped tests, and what they need:\n");
    skipped.forEach((reason, tests) -> text.append("  %3d  %s%n".formatted(tests, reason)));
    return text.toString();
  }

  private static List<Path> reports(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(".xml")).toList();
    }
  }

  /** Adds the reasons of one report; a class that is skipped as a whole counts once. */
  static void count(Path report, Map<String, Integer> skipped) throws Exception {
    Document document =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(report.toFile());
    NodeList elements = document.getElementsByTagName("skipped");
    for (int i = 0; i < elements.getLength(); i++) {
      String reason = ((Element) elements.item(i)).getAttribute("message").strip();
      skipped.merge(reason.lines().findFirst().orElse("no reason given"), 1, Integer::sum);
    }
  }
}
