package tellosimulator.command;

/** Parameters that several commands share. */
final class DroneParameters {

  private DroneParameters() {}

  static Parameter cm(String name) {
    return Parameter.number(name, "cm", -500, 500);
  }

  static Parameter curveSpeed() {
    return Parameter.number("speed", "cm/s", 10, 60);
  }

  static Parameter stick(String name) {
    return Parameter.number(name, "", -100, 100);
  }

  static Parameter pad(String name) {
    return Parameter.choice(name, "m1", "m2", "m3", "m4", "m5", "m6", "m7", "m8", "m-1", "m-2");
  }

  static Parameter rgb(String name) {
    return Parameter.whole(name, 0, 255);
  }

  static Parameter hertz() {
    return Parameter.number("t", "Hz", 0.1, 2.5);
  }

  static Parameter colour() {
    return Parameter.choice("colour", "r", "b", "p");
  }
}
