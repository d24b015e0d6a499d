package tellosimulator;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;

/** The compiled classes of the project, imported once per JVM. */
final class ProjectClasses {

  static final JavaClasses MAIN = compiledBeside(Main.class);

  /** The classes of the tests and, where they are compiled, of the programs in src/bench. */
  static final JavaClasses TESTS = compiledBeside(ProjectClasses.class);

  private ProjectClasses() {}

  /** Returns all classes of the folder from which a class was loaded. */
  private static JavaClasses compiledBeside(Class<?> type) {
    return new ClassFileImporter()
        .importUrl(type.getProtectionDomain().getCodeSource().getLocation());
  }
}
