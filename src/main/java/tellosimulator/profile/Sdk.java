package tellosimulator.profile;

/** The generations of the drone's text interface, oldest first. */
public enum Sdk {
  SDK_1_3("1.3"),
  SDK_2_0("2.0"),
  SDK_3_0("3.0");

  private final String version;

  Sdk(String version) {
    this.version = version;
  }

  /** As the vendor's guides write it. */
  public String version() {
    return version;
  }
}
