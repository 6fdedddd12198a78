/** What each contact carries altogether, and how much of it is closed. */

import { Digits } from "../../ui/Digits";
import { rounded } from "../../ui/readable";
import type { ContactSums } from "./contacts";

export function ContactTable({ analysis, contacts }: { readonly analysis: string; readonly contacts: readonly ContactSums[] }) {
  if (contacts.length === 0) return null;
  return (
    <div class="zone-table">
      <table class="study-table">
        <caption>{contacts.length === 1 ? "One contact" : `${contacts.length} contacts`}</caption>
        <thead>
          <tr>
            {["Contact", "Points", "Closed", "Open", "Normal force (N)", "Friction force (N)", "Largest pressure (Pa)"].map((head) => (
              <th scope="col" key={head}>
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {contacts.map((contact) => {
            const path = `${analysis}.contacts.${contact.name}`;
            return (
              <tr key={contact.name}>
                <th scope="row">{contact.name}</th>
                <td><Digits dataKey={`${path}.points`} value={contact.points} /></td>
                <td><Digits dataKey={`${path}.closed`} value={contact.closed} /></td>
                <td><Digits dataKey={`${path}.open`} value={contact.open} /></td>
                <td><Digits dataKey={`${path}.normal_force`} value={contact.normalForce} /></td>
                <td title="The magnitude of the friction forces together">{rounded(contact.frictionForce)}</td>
                <td><Digits dataKey={`${path}.pressure_max`} value={contact.pressure} /></td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}
