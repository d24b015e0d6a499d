package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.command.CommandSyntax;

/** Checks that docs/compare-with-a-drone.md omits no command. */
class ComparePageTest {

  @ParameterizedTest
  @EnumSource
  void eachCommandIsCompared(CommandSyntax command) throws IOException {
    String verb = command.verb().split(" ", -1)[0].equals("EXT") ? "EXT" : command.verb();

    assertThat(Files.readString(Path.of("docs", "compare-with-a-drone.md")))
        .containsPattern("`" + java.util.regex.Pattern.quote(verb) + "[ `]");
  }
}
