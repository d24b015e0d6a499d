package tellosimulator.extension;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.extension.MatrixEffect.Move;
import tellosimulator.extension.MatrixPicture.Color;
import tellosimulator.time.SimTime;

class BoardLightsTest {

  private static final SimTime START = SimTime.ZERO.plus(10);

  @Test
  void aSteadyLampKeepsItsColor() {
    BoardLights lights = lamp(LampEffect.steady(0x0080ff));

    assertThat(lights.lampRgb(after(0))).isEqualTo(0x0080ff);
    assertThat(lights.lampRgb(after(60))).isEqualTo(0x0080ff);
    assertThat(lights.animated()).isFalse();
  }

  @Test
  void aBreathingLampIsFullHalfwayThroughAPeriod() {
    BoardLights lights = lamp(LampEffect.breathing(0.5, 0x0080ff)); // 2 s

    assertThat(lights.lampRgb(after(0))).isZero();
    assertThat(lights.lampRgb(after(0.5))).isEqualTo(0x004080); // half of 128 and of 255
    assertThat(lights.lampRgb(after(1))).isEqualTo(0x0080ff);
    assertThat(lights.lampRgb(after(2))).isZero();
    assertThat(lights.animated()).isTrue();
  }

  @Test
  void aBlinkingLampTakesTurns() {
    BoardLights lights = lamp(LampEffect.blinking(2, 0xff0000, 0x0000ff)); // 0.25 s each

    assertThat(lights.lampRgb(after(0.1))).isEqualTo(0xff0000);
    assertThat(lights.lampRgb(after(0.3))).isEqualTo(0x0000ff);
    assertThat(lights.lampRgb(after(0.6))).isEqualTo(0xff0000);
  }

  @Test
  void aPatternGoesRowByRow() {
    MatrixPicture picture = MatrixPicture.ofPattern("rb0p0000" + "000000r");

    assertThat(picture.red(0, 0)).isTrue();
    assertThat(picture.blue(0, 0)).isFalse();
    assertThat(picture.blue(0, 1)).isTrue();
    assertThat(picture.lit(0, 2)).isFalse();
    assertThat(picture.red(0, 3) && picture.blue(0, 3)).as("purple").isTrue();
    assertThat(picture.red(1, 6)).isTrue();
    assertThat(Long.bitCount(picture.red() | picture.blue())).isEqualTo(4);
    assertThat(MatrixPicture.ofPattern("r".repeat(100)).red()).as("64 dots").isEqualTo(-1);
  }

  @Test
  void aCharacterIsReadable() {
    assertThat(drawn(MatrixPicture.ofCharacter('L', Color.RED)))
        .isEqualTo(
            """
            .#......
            .#......
            .#......
            .#......
            .#......
            .#......
            .#####..
            ........
            """);
    assertThat(MatrixPicture.ofCharacter('l', Color.RED))
        .as("small letters are capital ones")
        .isEqualTo(MatrixPicture.ofCharacter('L', Color.RED));
    assertThat(MatrixPicture.ofCharacter('\u20ac', Color.BLUE)).isEqualTo(MatrixPicture.DARK);
  }

  @Test
  void aTextMovesToTheLeftByDotsAndBeginsAgain() {
    MatrixPicture letter = MatrixPicture.ofCharacter('L', Color.BLUE);
    BoardLights lights = show(MatrixEffect.text("L", Color.BLUE, Move.LEFT, 2));

    assertThat(lights.picture(after(0))).isEqualTo(letter);
    // the upright of the L is in column 1, and after half a second in column 0
    assertThat(lights.picture(after(0.5)).blue(0, 0)).isTrue();
    assertThat(lights.picture(after(4))).as("8 dots: gone").isEqualTo(MatrixPicture.DARK);
    assertThat(lights.picture(after(8))).as("16 dots: there again").isEqualTo(letter);
    assertThat(lights.animated()).isTrue();
  }

  @Test
  void aTextMovesInAllDirections() {
    assertThat(show(MatrixEffect.text("L", Color.RED, Move.RIGHT, 1)).picture(after(1)).red(0, 2))
        .isTrue();
    // the foot of the L is row 6
    assertThat(show(MatrixEffect.text("L", Color.RED, Move.UP, 1)).picture(after(1)).red(5, 4))
        .isTrue();
    assertThat(show(MatrixEffect.text("L", Color.RED, Move.DOWN, 1)).picture(after(1)).red(7, 4))
        .isTrue();
  }

  @Test
  void aGreetingOutlastsThePower() {
    MatrixPicture dot = MatrixPicture.ofPattern("r");
    BoardLights lights = lamp(LampEffect.steady(0xffffff)).after(new LightOrder.Greet(dot), START);
    assertThat(lights.picture(START)).isEqualTo(dot);

    BoardLights off = lights.after(new LightOrder.Dim(3), START).poweredOff();
    assertThat(off.picture(START)).isEqualTo(MatrixPicture.DARK);
    assertThat(off.lampRgb(START)).isZero();

    BoardLights on = off.poweredOn(START);
    assertThat(on.picture(START)).isEqualTo(dot);
    assertThat(on.brightness()).isEqualTo(BoardLights.BRIGHTEST);
    BoardLights cleared = on.after(new LightOrder.Greet(MatrixPicture.DARK), START);
    assertThat(cleared.poweredOn(START).picture(START)).isEqualTo(MatrixPicture.DARK);
  }

  private static SimTime after(double seconds) {
    return START.plus(seconds);
  }

  private static BoardLights lamp(LampEffect effect) {
    return BoardLights.DARK.after(new LightOrder.Shine(effect), START);
  }

  private static BoardLights show(MatrixEffect effect) {
    return BoardLights.DARK.after(new LightOrder.Show(effect), START);
  }

  private static String drawn(MatrixPicture picture) {
    return IntStream.range(0, MatrixPicture.SIZE)
        .mapToObj(
            row ->
                IntStream.range(0, MatrixPicture.SIZE)
                    .mapToObj(column -> picture.lit(row, column) ? "#" : ".")
                    .collect(Collectors.joining("", "", "\n")))
        .collect(Collectors.joining());
  }
}
