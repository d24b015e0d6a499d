package tellosimulator.command;

import java.util.List;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/** The words after a verb, read as what the command's parameters say. */
record Arguments(List<String> words) {

  String word(int index) {
    return words.get(index);
  }

  double number(int index) {
    return Double.parseDouble(word(index));
  }

  int integer(int index) {
    return (int) number(index);
  }

  double metres(int index) {
    return Frames.metres(number(index));
  }

  /** Radians counter-clockwise of degrees clockwise. */
  double heading(int index) {
    return Frames.headingOfYaw(number(index));
  }

  /** Three words in centimetres from {@code index} on [m]. */
  Vec3 point(int index) {
    return new Vec3(metres(index), metres(index + 1), metres(index + 2));
  }

  PadChoice pad(int index) {
    return new PadChoice(Integer.parseInt(word(index).substring(1)));
  }
}
