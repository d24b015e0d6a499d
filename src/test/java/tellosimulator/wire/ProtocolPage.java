package tellosimulator.wire;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.command.CommandSyntax;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.testing.GeneratedPage;
import tellosimulator.wire.FactIndex.Fact;

/**
 * Generates the page on the text interface from a template, the table of commands and the facts.
 */
final class ProtocolPage {

  static final GeneratedPage PAGE = new GeneratedPage("protocol");

  private static final String BOARD = "EXT ";

  private ProtocolPage() {}

  /** Returns the expected text of the page. */
  static String text() {
    return PAGE.template()
        .replace("{{commands}}", commands())
        .replace("{{missing}}", reasons(Fact::missing))
        .replace(
            "{{elsewhere}}",
            FactIndex.facts().stream()
                .filter(Fact::elsewhere)
                .map(fact -> "- " + fact.summary() + ": " + fact.reason())
                .collect(Collectors.joining("\n")));
  }

  private static String reasons(Predicate<Fact> chosen) {
    return FactIndex.facts().stream()
        .filter(chosen)
        .map(fact -> "- " + fact.reason())
        .collect(Collectors.joining("\n"));
  }

  private static String commands() {
    Stream<String> bySdk =
        Arrays.stream(Sdk.values())
            .map(sdk -> table(title(sdk), syntax -> syntax.since() == sdk && !isForBoard(syntax)));
    String board = table("For the extension board, profile `tt`", ProtocolPage::isForBoard);
    return Stream.concat(bySdk, Stream.of(board)).collect(Collectors.joining("\n\n"));
  }

  private static String title(Sdk sdk) {
    String profiles =
        Arrays.stream(Profile.values())
            .filter(profile -> profile.knows(sdk))
            .map(profile -> "`" + profile.option() + "`")
            .collect(Collectors.joining(", "));
    return "Since SDK " + sdk.version() + ": " + profiles;
  }

  private static boolean isForBoard(CommandSyntax syntax) {
    return syntax.verb().startsWith(BOARD);
  }

  private static String table(String title, Predicate<CommandSyntax> chosen) {
    List<String> rows =
        Arrays.stream(CommandSyntax.values()).filter(chosen).map(ProtocolPage::row).toList();
    return """
        ### %s
        | command | parameters | reply | value out of range | on the ground | while another runs | source |
        |---|---|---|---|---|---|---|
        %s"""
        .formatted(title, String.join("\n", rows));
  }

  private static String row(CommandSyntax syntax) {
    return Stream.of(
            "`" + syntax.usage() + "`",
            syntax.ranges(),
            syntax.success(),
            syntax.limited() ? "`" + syntax.outOfRange().text() + "`" : "",
            syntax.needsFlight() ? "`error Motor stop`" : "",
            syntax.busyRule().words(),
            syntax.source())
        .map(cell -> cell.isEmpty() ? "–" : cell)
        .collect(Collectors.joining(" | ", "| ", " |"));
  }
}
