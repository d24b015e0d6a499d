package tellosimulator.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import tellosimulator.cli.Invocation.Action;
import tellosimulator.words.Translation;

class InvocationTest {

  private static final Action NOTHING = () -> ExitCode.DONE;

  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int run(List<String> words, Supplier<Action> reading) {
    PrintStream out =
        new PrintStream(OutputStream.nullOutputStream(), true, StandardCharsets.UTF_8);
    ProgramOutput output =
        new ProgramOutput(
            out,
            new PrintStream(err, true, StandardCharsets.UTF_8),
            out,
            () -> Translation.ENGLISH,
            new ProgramInput(InputStream.nullInputStream(), task -> {}));
    OptionList choices = OptionList.ofSimulator();
    choices.flag("--on", "On.");
    return new Invocation(choices.commandLine(() -> new String[0]), SubcommandName.words(), output)
        .run(words.toArray(String[]::new), reading);
  }

  private String told() {
    return err.toString(StandardCharsets.UTF_8).strip();
  }

  @Test
  void optionsThatDoNotFitTogetherAreAMistake() {
    int code =
        run(
            List.of("--on"),
            () -> {
              throw new IllegalArgumentException("--on needs --off");
            });

    assertThat(code).isEqualTo(ExitCode.WRONG_OPTIONS);
    assertThat(told()).isEqualTo("--on needs --off. Try --help.");
  }

  @Test
  void aMistakeWithoutASentenceIsToldAllTheSame() {
    int code =
        run(
            List.of(),
            () -> {
              throw new IllegalArgumentException();
            });

    assertThat(code).isEqualTo(ExitCode.WRONG_OPTIONS);
    assertThat(told()).isEqualTo("The options are wrong. Try --help.");
  }

  /** The caller reports it as an error of the program. */
  @Test
  void anErrorOfTheActionIsNoMistakeInTheOptions() {
    Action broken =
        () -> {
          throw new IllegalArgumentException("prefix is -1, but must be 0 to 32");
        };

    assertThatThrownBy(() -> run(List.of(), () -> broken))
        .isInstanceOf(IllegalArgumentException.class);
    assertThat(told()).isEmpty();
  }

  @Test
  void aSubcommandIsMeantOnlyWhereItCanStand() {
    assertThat(run(List.of("exprot", "x"), () -> NOTHING)).isEqualTo(ExitCode.WRONG_OPTIONS);
    assertThat(told()).isEqualTo("There is no option exprot, did you mean export? Try --help.");

    err.reset();
    assertThat(run(List.of("--on", "exprot"), () -> NOTHING)).isEqualTo(ExitCode.WRONG_OPTIONS);
    assertThat(told()).isEqualTo("There is no option exprot. Try --help.");
  }
}
