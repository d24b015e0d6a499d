package tellosimulator;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;

/** The compiled classes of the project, imported once in a JVM. */
final class ProjectClasses {

  static final JavaClasses MAIN = compiledBeside(Main.class);

  /** Of the tests and, where they are compiled, of the programs in src/bench. */
  static final JavaClasses TESTS = compiledBeside(ProjectClasses.class);

  private ProjectClasses() {}

  /** All classes of the folder that a class was loaded from. */
  private static JavaClasses compiledBeside(Class<?> type) {
    return new ClassFileImporter()
        .importUrl(type.getProtectionDomain().getCodeSource().getLocation());
  }
}
