package tellosimulator.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;
import tellosimulator.json.Json;

/** Checks that files with the project's name, version or libraries agree with pom.xml. */
class ReleaseFilesTest {

  private static final Pattern VARIABLE = Pattern.compile("\\$\\{([^}]+)}");

  private static final Pattern RELEASE =
      Pattern.compile("(?m)^## (\\d+\\.\\d+\\.\\d+) - \\d{4}-\\d\\d-\\d\\d$");

  /** A full commit hash, followed by its version. */
  private static final Pattern PINNED =
      Pattern.compile("[\\w/-]+@[0-9a-f]{40} # v\\d+(\\.\\d+){2}");

  private static final Pattern ACTION = Pattern.compile("(?m)^ +(?:- )?uses: (.*)$");

  private final Map<String, String> properties = new TreeMap<>();
  private final List<Map<String, String>> dependencies = new ArrayList<>();
  private final Map<String, String> project;

  ReleaseFilesTest() throws Exception {
    Document pom =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(Path.of("pom.xml").toFile());
    Element root = pom.getDocumentElement();
    project = texts(root);
    properties.putAll(texts(child(root, "properties")));
    NodeList declared = child(root, "dependencies").getElementsByTagName("dependency");
    for (int i = 0; i < declared.getLength(); i++) {
      dependencies.add(texts((Element) declared.item(i)));
    }
  }

  @Test
  void theNewestReleaseOfTheChangelogIsThisVersion() throws IOException {
    List<String> releases =
        RELEASE
            .matcher(Files.readString(Path.of("CHANGELOG.md")))
            .results()
            .map(release -> release.group(1))
            .toList();

    assertThat(releases).isNotEmpty();
    assertThat(releases.get(0)).isEqualTo(version().replace("-SNAPSHOT", ""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"docs/testing.md", "examples/testing/pom.xml"})
  void whatPeopleCopyNamesThisVersion(String file) throws IOException {
    assertThat(Files.readString(Path.of(file)).replaceAll("\\s+", ""))
        .contains(
            "<groupId>%s</groupId><artifactId>%s</artifactId><version>%s</version>"
                .formatted(group(), artifact(), version()));
  }

  @Test
  void jreleaserPublishesThisProject() throws IOException {
    Map<?, ?> file = yaml(Path.of("jreleaser.yml"));
    Map<?, ?> named = map(file, "project");
    Map<?, ?> java = map(map(named, "languages"), "java");
    Map<?, ?> github = map(map(file, "release"), "github");

    assertThat(text(named, "name")).isEqualTo(artifact());
    assertThat(text(named, "version")).isEqualTo(version());
    assertThat(text(named, "description")).isEqualTo(project.get("description"));
    assertThat(text(named, "inceptionYear")).isEqualTo(project.get("inceptionYear"));
    assertThat(text(map(named, "links"), "homepage")).isEqualTo(project.get("url"));
    assertThat(text(java, "groupId")).isEqualTo(group());
    assertThat(text(java, "artifactId")).isEqualTo(artifact());
    assertThat(text(java, "version")).isEqualTo(properties.get("maven.compiler.release"));
    assertThat(text(java, "mainClass")).isEqualTo(properties.get("main.class"));
    assertThat("https://github.com/" + text(github, "owner") + "/" + text(github, "name"))
        .isEqualTo(project.get("url"));
  }

  @Test
  void jreleaserHandsOutWhatTheProfilesBuild() throws IOException {
    String pom =
        Files.readString(Path.of("pom.xml"))
            .replace("${project.build.directory}", "target")
            .replace("${project.build.finalName}", artifact());
    List<String> handedOut = new ArrayList<>();
    for (Object file : (List<?>) map(yaml(Path.of("jreleaser.yml")), "files").get("artifacts")) {
      handedOut.add(text((Map<?, ?>) file, "path"));
    }

    assertThat(handedOut).hasSize(3).contains("target/bom.json");
    assertThat(handedOut)
        .filteredOn(path -> path.endsWith(".jar"))
        .allMatch(path -> pom.contains("<outputFile>" + path + "</outputFile>"));
  }

  @Test
  void jbangStartsTheProgramWithAllItsLibraries() throws IOException {
    Map<?, ?> catalog = (Map<?, ?>) Json.value(Files.readString(Path.of("jbang-catalog.json")));
    Map<?, ?> alias = map(map(catalog, "aliases"), artifact());
    String library = group() + ":" + artifact() + ":" + version();

    assertThat(text(alias, "script-ref")).isEqualTo(library);
    assertThat(text(alias, "main")).isEqualTo(properties.get("main.class"));
    assertThat(text(alias, "java")).isEqualTo(properties.get("maven.compiler.release") + "+");
    assertThat(text(alias, "description")).isEqualTo(project.get("description"));
    assertThat(((List<?>) alias.get("dependencies")).stream().map(String::valueOf))
        .containsExactlyInAnyOrderElementsOf(
            Stream.concat(Stream.of(library + ":window"), librariesOfTheProgramAlone()).toList());
  }

  @Test
  void eachActionIsPinnedToACommit() throws IOException {
    try (Stream<Path> workflows = Files.list(Path.of(".github", "workflows"))) {
      for (Path workflow : workflows.toList()) {
        assertThat(keys(yaml(workflow))).contains("name", "on", "permissions", "jobs");
        assertThat(ACTION.matcher(Files.readString(workflow)).results().map(uses -> uses.group(1)))
            .as("%s", workflow)
            .filteredOn(used -> !used.startsWith("./")) // actions in the same commit
            .isNotEmpty()
            .allMatch(PINNED.asMatchPredicate());
      }
    }
  }

  @Test
  void githubReadsTheOtherFiles() throws IOException {
    assertThat(text(yaml(Path.of(".github", "dependabot.yml")), "version")).isEqualTo("2");
    try (Stream<Path> forms = Files.list(Path.of(".github", "ISSUE_TEMPLATE"))) {
      for (Path form : forms.filter(file -> !file.endsWith("config.yml")).toList()) {
        assertThat(keys(yaml(form))).as("%s", form).contains("name", "description", "body");
      }
    }
  }

  /** Returns the libraries that a project does not inherit, in the notation of jbang. */
  private Stream<String> librariesOfTheProgramAlone() {
    return dependencies.stream()
        .filter(one -> one.containsKey("optional") && !one.containsKey("scope"))
        .map(one -> one.get("groupId") + ":" + one.get("artifactId") + ":" + one.get("version"));
  }

  private String group() {
    return project.get("groupId");
  }

  private String artifact() {
    return project.get("artifactId");
  }

  private String version() {
    return project.get("version");
  }

  /**
   * Returns the texts of an element's children, by their names, with the pom's properties resolved.
   */
  private Map<String, String> texts(Element element) {
    UnaryOperator<String> filled =
        text ->
            VARIABLE
                .matcher(text)
                .replaceAll(
                    (MatchResult variable) ->
                        properties.getOrDefault(variable.group(1), "unknown").replace("$", "\\$"));
    Map<String, String> texts = new TreeMap<>();
    for (Node node = element.getFirstChild(); node != null; node = node.getNextSibling()) {
      if (node instanceof Element) {
        texts.put(node.getNodeName(), filled.apply(node.getTextContent().strip()));
      }
    }
    return texts;
  }

  private static Element child(Element parent, String name) {
    for (Node node = parent.getFirstChild(); node != null; node = node.getNextSibling()) {
      if (node instanceof Element element && element.getNodeName().equals(name)) {
        return element;
      }
    }
    throw new AssertionError("pom.xml has no " + name);
  }

  private static Map<?, ?> yaml(Path file) throws IOException {
    LoadSettings settings = LoadSettings.builder().setLabel(file.toString()).build();
    return (Map<?, ?>) new Load(settings).loadFromString(Files.readString(file));
  }

  private static Map<?, ?> map(Map<?, ?> parent, String key) {
    assertThat(parent.get(key)).as(key).isInstanceOf(Map.class);
    return (Map<?, ?>) parent.get(key);
  }

  private static List<String> keys(Map<?, ?> map) {
    return map.keySet().stream().map(String::valueOf).toList();
  }

  private static String text(Map<?, ?> parent, String key) {
    return String.valueOf(parent.get(key));
  }
}
