package tellosimulator.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.StringReader;
import java.lang.reflect.Field;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import tellosimulator.concurrent.FatalExit;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.GeneratedPage;
import tellosimulator.testing.HeadlessSimulators;

/**
 * Checks that {@code docs/options.md} contains every option, subcommand, exit code and console
 * command.
 */
class OptionsPageTest {

  private static final GeneratedPage PAGE = new GeneratedPage("options");

  private static final IVersionProvider VERSION = () -> new String[] {""};

  /** A placeholder {@code {{kind word...}}}. */
  private static final Pattern PART = Pattern.compile("\\{\\{(\\w+) ?([^}]*)}}");

  /** The name of an option in a text, unless it is already marked as code. */
  private static final Pattern OPTION = Pattern.compile("(?<![\\w`-])--[a-z][a-z-]*");

  private static final Pattern DEFAULT = Pattern.compile("(.*) Default: (.*)\\.");

  private final CommandSpec simulator = new Options().commandLine(VERSION).getCommandSpec();
  private final List<String> options = new ArrayList<>();
  private final List<String> subcommands = new ArrayList<>();

  @Test
  void thePageIsMadeFromTheCode() throws InterruptedException {
    String console = console();
    String text =
        PART.matcher(PAGE.template())
            .replaceAll(
                part -> Matcher.quoteReplacement(part(part.group(1), part.group(2), console)));

    PAGE.check(text, OptionsPageTest.class);
    assertThat(options)
        .containsExactlyInAnyOrderElementsOf(
            simulator.options().stream()
                .filter(option -> !option.hidden())
                .map(OptionSpec::longestName)
                .toList());
    assertThat(subcommands).containsExactlyInAnyOrderElementsOf(SubcommandName.words());
  }

  @Test
  void eachExitCodeHasARow() throws IllegalAccessException {
    List<Integer> codes = new ArrayList<>(List.of(FatalExit.CODE));
    for (Field field : ExitCode.class.getFields()) {
      codes.add(field.getInt(null));
    }

    assertThat(codes)
        .hasSizeGreaterThan(5)
        .allSatisfy(code -> assertThat(PAGE.template()).contains("\n| " + code + " | "));
  }

  private String part(String kind, String words, String console) {
    return switch (kind) {
      case "options" -> table(List.of(words.split(" ", -1)));
      case "subcommand" -> subcommand(words);
      default -> console;
    };
  }

  private String table(List<String> names) {
    options.addAll(names);
    return table(names.stream().map(simulator::findOption));
  }

  private static String table(Stream<OptionSpec> specs) {
    return specs
        .map(OptionsPageTest::row)
        .collect(Collectors.joining("\n", "| option | effect | default |\n|---|---|---|\n", ""));
  }

  private static String row(OptionSpec option) {
    String effect = String.join(" ", option.description()).replace("%%", "%");
    Matcher parts = DEFAULT.matcher(effect);
    boolean hasDefault = parts.matches();
    return Stream.of(
            usage(option),
            hasDefault ? parts.group(1) : effect,
            hasDefault ? parts.group(2) : option.required() ? "must be given" : "–")
        .map(OptionsPageTest::escaped)
        .collect(Collectors.joining(" | ", "| ", " |"));
  }

  private static String escaped(String cell) {
    return withCode(cell).replace("|", "\\|");
  }

  /** Returns a text with the names of options marked as code. */
  private static String withCode(String text) {
    return OPTION.matcher(text).replaceAll("`$0`");
  }

  private static String usage(OptionSpec option) {
    String value = option.arity().max() == 0 ? "" : " " + option.paramLabel();
    return Stream.of(option.names())
        .map(name -> "`" + name + value + "`")
        .collect(Collectors.joining(", "));
  }

  private String subcommand(String word) {
    subcommands.add(word);
    CommandSpec spec =
        SubcommandName.of(word).orElseThrow().subcommand().commandLine(VERSION).getCommandSpec();
    List<OptionSpec> own =
        spec.options().stream()
            .filter(option -> !List.of("--help", "--version").contains(option.longestName()))
            .toList();
    String positional =
        spec.positionalParameters().stream()
            .map(each -> " " + each.paramLabel())
            .collect(Collectors.joining());
    String required =
        own.stream()
            .filter(OptionSpec::required)
            .map(each -> " " + each.longestName() + " " + each.paramLabel())
            .collect(Collectors.joining());
    String described =
        spec.positionalParameters().stream()
            .filter(each -> each.paramLabel().startsWith("["))
            .map(each -> "\n\n" + withCode(String.join(" ", each.description())))
            .collect(Collectors.joining());
    return "### `%s%s%s`\n\n%s%s\n\n%s%s"
        .formatted(
            word,
            positional,
            required,
            String.join(" ", spec.usageMessage().header()),
            described,
            own.isEmpty() ? "" : table(own.stream()) + "\n\n",
            String.join(" ", spec.usageMessage().footer()).strip());
  }

  /** Returns the response to {@code help} of a program without a window. */
  private static String console() throws InterruptedException {
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    try (HeadlessSimulator simulator =
        HeadlessSimulators.of(Scenario.of(SimConfig.DEFAULT), AddressPlan.ofMachine(1, 0))) {
      simulator.run(
          new BufferedReader(new StringReader("help\nquit\n")),
          new PrintStream(printed, true, StandardCharsets.UTF_8));
    }
    return printed.toString(StandardCharsets.UTF_8).replace("\r", "").strip();
  }
}
