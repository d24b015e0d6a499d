package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Checks that docs/architecture.md shows the actual packages, and that it and CONTRIBUTING.md name
 * only what exists.
 */
@Tag("slow")
class ArchitecturePageTest {

  private static final Path PAGE = Path.of("docs", "architecture.md");
  private static final String ROOT = "tellosimulator";

  /** {@code Type}, {@code package.Type}, {@code Type.member}, in code style. */
  private static final Pattern NAME =
      Pattern.compile("`(?:[a-z.]+\\.)?([A-Z]\\w*[a-z]\\w*)((?:\\.\\w+)*)(?:\\(\\))?`");

  /** Types of other projects that the page names. */
  private static final Set<String> FOREIGN = Set.of("AnimationTimer", "StrictMath");

  private static final JavaClasses CLASSES = ProjectClasses.MAIN;

  private static final JavaClasses TESTS = ProjectClasses.TESTS;

  /** Run with {@code -DwritePage=true} to redraw the diagrams. */
  @ParameterizedTest
  @ValueSource(strings = {"packages", "scenery", "video", "view"})
  void thePictureIsWhatTheCodeSays(String name) throws IOException {
    Pattern place =
        Pattern.compile(
            "(<!-- picture: " + name + " -->\n).*?(<!-- end of picture -->)", Pattern.DOTALL);
    String picture =
        PackageGraph.of(CLASSES, name.equals("packages") ? ArchitecturePageTest::top : below(name))
            .reduced()
            .mermaid();
    String drawn =
        place.matcher(page()).replaceFirst(found -> found.group(1) + picture + found.group(2));
    if (Boolean.getBoolean("writePage")) {
      Files.writeString(PAGE, drawn);
    }

    assertThat(place.matcher(page()).results()).hasSize(1);
    assertThat(page())
        .as("%s; to draw it anew: mvn test -Dtest=ArchitecturePageTest -DwritePage=true", PAGE)
        .isEqualTo(drawn);
  }

  @Test
  void eachPackageHasARow() {
    Set<String> rows =
        Pattern.compile("^\\| `([a-z.]+)` \\|", Pattern.MULTILINE)
            .matcher(page().replaceFirst("(?s).*\n## Packages", "").replaceFirst("(?s)\n## .*", ""))
            .results()
            .map(row -> row.group(1))
            .collect(Collectors.toCollection(TreeSet::new));
    Set<String> packages =
        CLASSES.stream()
            .map(type -> relative(type.getPackageName()))
            .filter(name -> !name.isEmpty())
            .collect(Collectors.toCollection(TreeSet::new));

    assertThat(rows).isEqualTo(packages);
  }

  @ParameterizedTest
  @ValueSource(strings = {"docs/architecture.md", "CONTRIBUTING.md"})
  void eachNameIsThatOfATypeAndEachMemberIsThere(String page) {
    assertThat(NAME.matcher(text(Path.of(page))).results().filter(name -> !isKnown(name)))
        .extracting(MatchResult::group)
        .isEmpty();
  }

  @Test
  void aNameThatIsNotThereIsFound() {
    assertThat(NAME.matcher("`sim.Nothing`, `Simulation.nothing`").results())
        .hasSize(2)
        .noneMatch(ArchitecturePageTest::isKnown);
  }

  private static boolean isKnown(MatchResult name) {
    String simple = name.group(1);
    String members = name.group(2);
    JavaClasses where = simple.matches(".*(Test|IT)") ? TESTS : CLASSES;
    return FOREIGN.contains(simple)
        || where.stream()
            .filter(type -> type.getSimpleName().equals(simple))
            .anyMatch(type -> members.isEmpty() || has(type, members.substring(1)));
  }

  private static boolean has(JavaClass type, String member) {
    return type.getAllMembers().stream().anyMatch(each -> each.getName().equals(member))
        || CLASSES.stream()
            .anyMatch(each -> each.getName().endsWith(type.getSimpleName() + "$" + member));
  }

  private static String top(JavaClass type) {
    String name = type.getPackageName();
    return name.equals(ROOT) ? "Main" : relative(name).split("\\.", 2)[0];
  }

  /** Returns a function that groups the packages below one; the package itself keeps its name. */
  private static Function<JavaClass, String> below(String parent) {
    return type -> {
      String name = relative(type.getPackageName());
      return name.equals(parent) || name.startsWith(parent + ".")
          ? name.substring(name.lastIndexOf('.') + 1)
          : "";
    };
  }

  private static String relative(String packageName) {
    return packageName.startsWith(ROOT + ".") ? packageName.substring(ROOT.length() + 1) : "";
  }

  private static String page() {
    return text(PAGE);
  }

  private static String text(Path file) {
    try {
      return Files.readString(file, StandardCharsets.UTF_8).replace("\r", "");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
